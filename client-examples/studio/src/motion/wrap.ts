/** The rest of value / length that is never negative: 0 up to length. */
export function wrap(value: number, length: number): number {
  const rest = value % length;
  // A tiny negative rest plus length rounds up to length itself.
  return rest < 0 ? (rest + length) % length : rest + 0;
}
