import type { Tuft, Vec3 } from "../api/contract";

/** The tuft with one of its points elsewhere. */
export function movePoint<T extends Tuft>(tuft: T, place: number, point: Vec3): T {
  return { ...tuft, points: tuft.points.map((old, i) => (i === place ? point : old)) };
}
