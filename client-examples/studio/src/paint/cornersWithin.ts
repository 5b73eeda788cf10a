/** The triangles that have a corner in a ball. @param corners  x, y, z of three corners for every triangle */
export function cornersWithin(corners: ArrayLike<number>, [x, y, z]: readonly [number, number, number], radius: number): number[] {
  const within: number[] = [];
  for (let at = 0; at + 8 < corners.length; at += 9) {
    const isIn = [at, at + 3, at + 6].some((i) => (corners[i]! - x) ** 2 + (corners[i + 1]! - y) ** 2 + (corners[i + 2]! - z) ** 2 <= radius * radius);
    if (isIn) for (let i = at; i < at + 9; i++) within.push(corners[i]!);
  }
  return within;
}
