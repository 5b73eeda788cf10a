import type { Wave } from "../api/contract";

/**
 * Equation (1): how high the wave stands above the line from root to tip.
 * @param x  along the hair, 0 at the root to pi at the tip
 * @param phase  2 pi t / T, radians
 * @returns f(x, t), in units where the hair is pi long
 */
export function wavePoint(wave: Required<Wave>, x: number, phase: number): number {
  // A root that is a rounding error below 0 would give NaN; one at 0 would give -0.
  if (x <= 0) return 0;
  const { amplitude: a, spatial_period: k, lightness: s, tip_exponent: p } = wave;
  return -(a / s) * (x / Math.PI) ** p * (Math.cos(x / k - phase) + 1 / s);
}
