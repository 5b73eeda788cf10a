import type { Picture } from "../api/contract";

/**
 * The matrices that bring each tuft's vertices from rest into each picture: to the joint's place, turned about it.
 * @param pictures  of the service, a chain per tuft with one node more than the tuft has joints
 * @param rests  the joints of each tuft at rest, x y z, metres
 * @return  pictures x joints x 12: three rows of a 3x4 matrix
 */
export function poseMatrices(pictures: readonly Picture[], rests: readonly Float32Array[]): Float32Array {
  const joints = rests.reduce((sum, rest) => sum + rest.length / 3, 0);
  const matrices = new Float32Array(pictures.length * joints * 12);
  let out = 0;
  for (const { chains } of pictures) {
    rests.forEach((rest, tuft) => {
      const { positions, turns } = chains[tuft]!;
      for (let joint = 0; 3 * joint < rest.length; joint++) {
        const [x, y, z, w] = turns[joint]!;
        const place = positions[joint]!;
        const rows = [
          [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
          [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
          [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ] as const;
        for (let row = 0; row < 3; row++) {
          const [a, b, c] = rows[row]!;
          matrices[out++] = a;
          matrices[out++] = b;
          matrices[out++] = c;
          matrices[out++] = place[row]! - a * rest[3 * joint]! - b * rest[3 * joint + 1]! - c * rest[3 * joint + 2]!;
        }
      }
    });
  }
  return matrices;
}
