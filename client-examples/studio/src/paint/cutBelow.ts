import * as THREE from "three";

/** Position and normal of a corner: six numbers. */
type Corner = readonly [number, number, number, number, number, number];

function unit(x: number, y: number, z: number): [number, number, number] {
  const length = Math.sqrt(x * x + y * y + z * z) || 1;
  return [x / length, y / length, z / length];
}

function cornersOf(geometry: THREE.BufferGeometry): Corner[] {
  const position = geometry.getAttribute("position");
  const normal = geometry.getAttribute("normal");
  const corner = (i: number): Corner => [position.getX(i), position.getY(i), position.getZ(i), normal.getX(i), normal.getY(i), normal.getZ(i)];
  const { index } = geometry;
  return Array.from({ length: index ? index.count : position.count }, (_, i) => corner(index ? index.getX(i) : i));
}

/** The point between two corners at a height, which is exactly that. */
function crossing(a: Corner, b: Corner, y: number): Corner {
  const t = (y - a[1]) / (b[1] - a[1]);
  const at = (k: 0 | 2 | 3 | 4 | 5): number => a[k] + t * (b[k] - a[k]);
  return [at(0), y, at(2), at(3), at(4), at(5)];
}

/**
 * What lies above a level plane, without an index; a triangle that crosses is cut, and the rim goes straight down to a floor.
 * @param geometry  position and normal; nothing else is kept
 * @param y  height of the plane
 * @param column  how far the rim goes down
 * @param leftOut  whether a triangle is, by its middle and normal
 */
export function cutBelow(
  geometry: THREE.BufferGeometry,
  y: number,
  column: number,
  leftOut: (middle: Corner) => boolean = () => false,
): THREE.BufferGeometry {
  const corners = cornersOf(geometry);
  const kept: Corner[] = [];
  const rim: [Corner, Corner][] = [];
  for (let i = 0; i + 2 < corners.length; i += 3) {
    const triangle = [corners[i]!, corners[i + 1]!, corners[i + 2]!] as const;
    const mean = (k: 0 | 1 | 2 | 3 | 4 | 5): number => (triangle[0][k] + triangle[1][k] + triangle[2][k]) / 3;
    if (leftOut([mean(0), mean(1), mean(2), mean(3), mean(4), mean(5)])) continue;
    const polygon = triangle.flatMap((a, k) => {
      const b = triangle[(k + 1) % 3]!;
      return [...(a[1] > y ? [a] : []), ...(a[1] > y !== b[1] > y ? [crossing(a, b, y)] : [])];
    });
    for (let k = 2; k < polygon.length; k++) kept.push(polygon[0]!, polygon[k - 1]!, polygon[k]!);
    const [from, to, ...more] = polygon.filter((corner) => corner[1] === y);
    if (!from || !to || more.length > 0) continue;
    rim.push(polygon[0] === from && polygon.at(-1) === to ? [to, from] : [from, to]);
  }
  const middle = [0, 2].map((k) => rim.reduce((sum, [a]) => sum + a[k]!, 0) / rim.length) as [number, number];
  const wall = (p: Corner, height: number): Corner => [p[0], height, p[2], ...unit(p[0] - middle[0], 0, p[2] - middle[1])];
  const floor = (x: number, z: number): Corner => [x, y - column, z, 0, -1, 0];
  for (const [a, b] of rim) {
    kept.push(wall(a, y), wall(b, y - column), wall(b, y), wall(a, y), wall(a, y - column), wall(b, y - column));
    kept.push(floor(b[0], b[2]), floor(a[0], a[2]), floor(...middle));
  }
  const result = new THREE.BufferGeometry();
  result.setAttribute("position", new THREE.Float32BufferAttribute(kept.flatMap((corner) => corner.slice(0, 3)), 3));
  result.setAttribute("normal", new THREE.Float32BufferAttribute(kept.flatMap((corner) => corner.slice(3)), 3));
  return result;
}
