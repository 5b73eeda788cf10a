import type { WeldedMesh } from "./weldedMesh";

/**
 * A mesh of no more than so many vertices and triangles: vertices in one cell of a grid become the first of them, the grid as fine as can be
 * had by doubling its cells. A mesh that is small enough stays as it is.
 */
export function thinnedMesh(mesh: WeldedMesh, limit: number): WeldedMesh {
  let thinned = mesh;
  const spans = [0, 1, 2].map((axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (let at = axis; at < mesh.positions.length; at += 3) [low, high] = [Math.min(low, mesh.positions[at]!), Math.max(high, mesh.positions[at]!)];
    return high - low;
  });
  for (let cell = Math.max(...spans) / 1024; thinned.positions.length > 3 * limit || thinned.triangles.length > 3 * limit; cell *= 2) {
    const numbers = new Map<string, number>();
    const positions: number[] = [];
    const numberOf = Array.from({ length: mesh.positions.length / 3 }, (_, i) => {
      const place = mesh.positions.slice(3 * i, 3 * i + 3);
      const key = place.map((part) => Math.floor(part / cell)).join();
      const known = numbers.get(key);
      if (known !== undefined) return known;
      numbers.set(key, numbers.size);
      positions.push(...place);
      return numbers.size - 1;
    });
    const triangles: number[] = [];
    for (let at = 0; at < mesh.triangles.length; at += 3) {
      const [a, b, c] = [numberOf[mesh.triangles[at]!]!, numberOf[mesh.triangles[at + 1]!]!, numberOf[mesh.triangles[at + 2]!]!];
      if (a !== b && b !== c && c !== a) triangles.push(a, b, c);
    }
    thinned = { positions, triangles };
  }
  return thinned;
}
