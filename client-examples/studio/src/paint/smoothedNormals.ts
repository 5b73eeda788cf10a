const kGrid = 1e6; // vertices in one cell of a micrometre are at one place

/**
 * Normals averaged over the vertices at one place: at a cap's rim and a texture's seam an outline's hull must not tear.
 * Cost O(vertices): 200 tufts of 400 vertices take about ten milliseconds.
 * @param positions  x, y, z of every vertex, metres
 * @param normals  as many
 * @return  as many, of length 1; where the normals cancel out, the vertex's own
 */
export function smoothedNormals(positions: ArrayLike<number>, normals: ArrayLike<number>): Float32Array<ArrayBuffer> {
  const count = Math.floor(positions.length / 3);
  let size = 16;
  while (size < 2 * count) size *= 2;
  const table = new Int32Array(size).fill(-1); // by hash: the first vertex at a place
  const cells = new Int32Array(3 * count);
  const first = new Int32Array(count);
  const sums = new Float64Array(3 * count);
  for (let i = 0; i < count; i++) {
    const [x, y, z] = [Math.round(positions[3 * i]! * kGrid), Math.round(positions[3 * i + 1]! * kGrid), Math.round(positions[3 * i + 2]! * kGrid)];
    cells[3 * i] = x;
    cells[3 * i + 1] = y;
    cells[3 * i + 2] = z;
    let hash = Math.imul(x, 0x9e3779b1) ^ Math.imul(y, 0x85ebca6b) ^ Math.imul(z, 0xc2b2ae35);
    hash ^= hash >>> 15;
    let slot = hash & (size - 1);
    let other = table[slot]!;
    while (other >= 0 && (cells[3 * other] !== cells[3 * i] || cells[3 * other + 1] !== cells[3 * i + 1] || cells[3 * other + 2] !== cells[3 * i + 2])) {
      slot = (slot + 1) & (size - 1);
      other = table[slot]!;
    }
    if (other < 0) other = table[slot] = i;
    first[i] = other;
    for (let k = 0; k < 3; k++) sums[3 * other + k]! += normals[3 * i + k]!;
  }
  const result = new Float32Array(3 * count);
  for (let i = 0; i < count; i++) {
    const at = 3 * first[i]!;
    const [x, y, z] = [sums[at]!, sums[at + 1]!, sums[at + 2]!];
    const length = Math.sqrt(x * x + y * y + z * z);
    if (length > 1e-9) {
      result[3 * i] = x / length;
      result[3 * i + 1] = y / length;
      result[3 * i + 2] = z / length;
    } else {
      for (let k = 0; k < 3; k++) result[3 * i + k] = normals[3 * i + k]!;
    }
  }
  return result;
}
