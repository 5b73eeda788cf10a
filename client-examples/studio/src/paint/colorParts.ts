/** Red, green and blue of #rrggbb, 0..1. */
export function colorParts(color: string): [number, number, number] {
  const part = (at: number) => parseInt(color.slice(at, at + 2), 16) / 255;
  return [part(1), part(3), part(5)];
}
