const kDecimals = 1e6; // to a micrometre

/** As the service's ScalpMesh. */
export interface WeldedMesh {
  readonly positions: number[];
  readonly triangles: number[];
}

/**
 * Loose triangles as a mesh with shared vertices, rounded to a micrometre. Triangles that have no area after that are left out.
 * @param corners  x, y, z of three corners for every triangle, metres
 */
export function weldedMesh(corners: ArrayLike<number>): WeldedMesh {
  const positions: number[] = [];
  const triangles: number[] = [];
  const numbers = new Map<string, number>();
  const numberOf = (at: number): number => {
    const place = [0, 1, 2].map((k) => Math.round(corners[at + k]! * kDecimals) / kDecimals);
    const key = place.join();
    const known = numbers.get(key);
    if (known !== undefined) return known;
    numbers.set(key, numbers.size);
    positions.push(...place);
    return numbers.size - 1;
  };
  for (let at = 0; at + 8 < corners.length; at += 9) {
    const [a, b, c] = [numberOf(at), numberOf(at + 3), numberOf(at + 6)] as const;
    if (a !== b && b !== c && c !== a) triangles.push(a, b, c);
  }
  return { positions, triangles };
}
