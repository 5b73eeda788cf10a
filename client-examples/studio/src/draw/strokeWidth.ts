import type { Vec3 } from "../api/contract";
import { rangeOf } from "../api/rangeOf";
import { distance } from "../model/vector";

const kEven = 0.5; // the pressure that a mouse reports
const kThinnest = 0.35; // of the chosen diameter, at no pressure at all

/**
 * How thick a pen draws, and where: the greatest pressure gives the diameter, its place the widest place. A mouse, whose pressure is
 * even, gives what is chosen.
 * @param pressures  0..1, one for each point
 */
export function strokeWidth(points: readonly Vec3[], pressures: readonly number[], chosen: { diameter: number; widest_at: number }): { diameter: number; widest_at: number } {
  const strongest = pressures.reduce((best, pressure, i) => (pressure > pressures[best]! ? i : best), 0);
  const weakest = Math.min(...pressures);
  const most = pressures[strongest] ?? kEven;
  if (most === weakest && most === kEven) return chosen;
  const range = rangeOf("Tuft", "diameter");
  const factor = most <= kEven ? kThinnest + (1 - kThinnest) * (most / kEven) : 1 + (most - kEven) / kEven;
  const diameter = Math.round(Math.max(range.minimum, Math.min(range.maximum, chosen.diameter * factor)));
  const upTo = (end: number) => points.slice(1, end + 1).reduce((sum, point, i) => sum + distance(points[i]!, point), 0);
  const place = Math.round((100 * upTo(strongest)) / (upTo(points.length - 1) || 1));
  return { diameter, widest_at: most - weakest < 0.1 ? chosen.widest_at : Math.max(10, Math.min(90, place)) };
}
