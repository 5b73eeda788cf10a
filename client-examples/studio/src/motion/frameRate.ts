/**
 * Frames per second as a number.
 * @param fps  a number, or a fraction as the contract writes it, such as "24000/1001"
 * @throws RangeError if it is no frame rate
 */
export function frameRate(fps: number | string): number {
  const parts = String(fps).split("/").map(Number);
  const rate = (parts[0] ?? 0) / (parts[1] ?? 1);
  if (parts.length > 2 || !(rate > 0 && Number.isFinite(rate))) throw new RangeError(`${fps} is no frame rate`);
  return rate;
}
