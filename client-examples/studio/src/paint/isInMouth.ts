/** Whether a point of the bundled head, in its file's frame, belongs to the bag behind the lips. */
export function isInMouth(x: number, y: number, z: number): boolean {
  return Math.abs(x) < 0.032 && y > 1.45 && y < 1.515 && z > 0.04 && z < 0.15 - Math.abs(x);
}
