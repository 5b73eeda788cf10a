import type { HeadBall } from "./HeadBall";

const kBundled = 0.1; // metres, the radius of the bundled head

/** How large a head is beside the bundled one: what is drawn around it is as much larger. */
export function headScale({ radius }: HeadBall): number {
  return radius / kBundled;
}
