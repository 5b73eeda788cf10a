import type { Head, Vec3 } from "../api/contract";

const kCenter: Vec3 = [0, 0, 0];

/** How much two heads differ: their centers by how many radii, and their sizes. A tuft of diameter 100 is one radius thick. */
function difference(a: Head, b: Head): number {
  const [p, q] = [a.center ?? kCenter, b.center ?? kCenter];
  const size = a.diameter_at_100 ?? 0.1;
  const away = Math.sqrt((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 + (p[2] - q[2]) ** 2) / size;
  return away + Math.abs(Math.log((b.diameter_at_100 ?? 0.1) / size));
}

/**
 * Which head hair belongs on: the one whose measures are nearest to the document's. So undoing shows the head that was there.
 * @param heads  not empty; of two that are as near, the first one
 */
export function headFor<T extends { readonly head: Head }>(wanted: Head, heads: readonly T[]): T {
  return heads.reduce((best, one) => (difference(one.head, wanted) < difference(best.head, wanted) ? one : best));
}
