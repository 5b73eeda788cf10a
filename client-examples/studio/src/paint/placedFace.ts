import type { HeadPlace } from "./HeadPlace";
import type { Decal } from "./toonMaterial";

// In the file's frame of the bundled head, metres from the floor.
const kFace = { x: 0, y: 1.492, half: [0.072, 0.083] } as const; // the drawn one's middle and half its sides
const kFront = 0.102; // the jaw, which is narrow enough for the cheeks' blush; what lies farther back gets none

/** Where the drawn face lies on the bundled head, in the hair's frame. */
export function placedFace({ scale, position }: HeadPlace): Omit<Decal, "texture"> {
  const x = (side: number): number => scale[0] * (kFace.x + side * kFace.half[0]) + position[0];
  const y = (side: number): number => scale[1] * (kFace.y + side * kFace.half[1]) + position[1];
  return { box: [x(-1), y(-1), x(1), y(1)], front: scale[2] * kFront + position[2] };
}
