import type { Vec3 } from "../api/contract";
import { add, distance, dot, scale, subtract } from "../model/vector";

function distanceToSegment(point: Vec3, from: Vec3, to: Vec3): number {
  const along = subtract(to, from);
  const t = Math.max(0, Math.min(1, dot(subtract(point, from), along) / (dot(along, along) || 1)));
  return distance(point, add(from, scale(along, t)));
}

/**
 * The points of a freehand stroke that are worth keeping: none of the others lies further than `tolerance` from the line through
 * them. The first and the last stay.
 * Source: U. Ramer, D. H. Douglas and T. K. Peucker, 1972 and 1973.
 * @return  their numbers, ascending
 */
export function simplifyStroke(points: readonly Vec3[], tolerance: number): number[] {
  const kept = new Set([0, points.length - 1]);
  const stretches: [number, number][] = [[0, points.length - 1]];
  for (let stretch = stretches.pop(); stretch; stretch = stretches.pop()) {
    const [from, to] = stretch;
    let furthest = from;
    let most = tolerance;
    for (let i = from + 1; i < to; i++) {
      const away = distanceToSegment(points[i]!, points[from]!, points[to]!);
      if (away > most) [furthest, most] = [i, away];
    }
    if (furthest === from) continue;
    kept.add(furthest);
    stretches.push([from, furthest], [furthest, to]);
  }
  return [...kept].filter((i) => i >= 0).sort((a, b) => a - b);
}
