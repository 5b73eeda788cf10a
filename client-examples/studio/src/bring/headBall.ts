import type { Vec3 } from "../api/contract";
import type { HeadBall } from "../model/HeadBall";

interface Slice { left: number; right: number; back: number; front: number }

const kSlices = 96;
const kNeck = 0.6; // of the widest cross section above: less is a neck
const kSkullShare = 0.42; // of the head's height from crown to neck; the rest is jaw

/** From the crown down: the sides of the box around all triangles that pass through each slice. */
function slicesOf(corners: ArrayLike<number>, bottom: number, top: number): Slice[] {
  const slices = Array.from({ length: kSlices }, (): Slice => ({ left: Infinity, right: -Infinity, back: Infinity, front: -Infinity }));
  const sliceAt = (y: number) => Math.min(kSlices - 1, Math.max(0, Math.floor(((top - y) / (top - bottom)) * kSlices)));
  for (let at = 0; at + 8 < corners.length; at += 9) {
    const [x, y, z] = [0, 1, 2].map((axis) => [corners[at + axis]!, corners[at + axis + 3]!, corners[at + axis + 6]!]) as [number[], number[], number[]];
    for (let i = sliceAt(Math.max(...y)); i <= sliceAt(Math.min(...y)); i++) {
      const slice = slices[i]!;
      slice.left = Math.min(slice.left, ...x);
      slice.right = Math.max(slice.right, ...x);
      slice.back = Math.min(slice.back, ...z);
      slice.front = Math.max(slice.front, ...z);
    }
  }
  return slices;
}

/** The slices above the neck: all, if it gets nowhere narrower. */
function aboveNeck(slices: readonly Slice[]): readonly Slice[] {
  let widest = 0;
  for (const [i, { left, right, back, front }] of slices.entries()) {
    const area = Math.max(0, right - left) * Math.max(0, front - back);
    if (area > widest) widest = area;
    else if (area < kNeck * widest && i > 4) return slices.slice(0, i);
  }
  return slices;
}

function middle(values: number[]): number {
  return values.sort((a, b) => a - b)[values.length >> 1] ?? 0;
}

/**
 * Finds the skull: about a known center, as far as half of what is above it lies away; else in what lies above the neck.
 * @param corners  x, y, z of three corners for every triangle; not empty
 * @param known  the head's center, if the file says where it is
 */
export function headBall(corners: ArrayLike<number>, known: Vec3 | null): HeadBall {
  if (known) {
    const away: number[] = [];
    for (let at = 0; at + 2 < corners.length; at += 3) {
      const [x, y, z] = [corners[at]! - known[0], corners[at + 1]! - known[1], corners[at + 2]! - known[2]];
      if (y > 0) away.push(Math.sqrt(x * x + y * y + z * z));
    }
    if (away.length > 0) return { center: known, radius: middle(away) };
  }
  let [bottom, top] = [Infinity, -Infinity];
  for (let at = 1; at < corners.length; at += 3) [bottom, top] = [Math.min(bottom, corners[at]!), Math.max(top, corners[at]!)];
  const slices = slicesOf(corners, bottom, top);
  const head = aboveNeck(slices).filter(({ left, right }) => left <= right);
  const [left, right] = [Math.min(...head.map((slice) => slice.left)), Math.max(...head.map((slice) => slice.right))];
  const [back, front] = [Math.min(...head.map((slice) => slice.back)), Math.max(...head.map((slice) => slice.front))];
  const height = ((top - bottom) * head.length) / kSlices;
  // A flat thing has no depth; anything but zero will do for its radius.
  const radius = Math.max(Math.min(kSkullShare * height, Math.max(right - left, front - back) / 2), (top - bottom) / kSlices, 1e-6);
  return { center: [(left + right) / 2, top - radius, (back + front) / 2], radius };
}
