import type { Vec3 } from "../api/contract";

/** The ball that a skull fills, in the frame and the unit of the file. */
export interface HeadBall {
  readonly center: Vec3;
  readonly radius: number;
}
