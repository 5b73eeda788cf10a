import type { Tuft, Vec3 } from "../api/contract";

/** The tuft with a point more, which becomes the one with the number `place` (0 is the root and stays). */
export function insertPoint<T extends Tuft>(tuft: T, place: number, point: Vec3): T {
  const at = Math.max(1, Math.min(tuft.points.length, place));
  return { ...tuft, points: [...tuft.points.slice(0, at), point, ...tuft.points.slice(at)] };
}
