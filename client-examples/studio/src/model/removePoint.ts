import type { Tuft } from "../api/contract";

/** The tuft without one of its points. The root stays, and so do the last two points. */
export function removePoint<T extends Tuft>(tuft: T, place: number): T {
  if (place < 1 || place >= tuft.points.length || tuft.points.length <= 2) return tuft;
  return { ...tuft, points: tuft.points.filter((_, i) => i !== place) };
}
