// A geometry cut by a level plane, and closed there.
import * as THREE from "three";

/**
 * What lies above y, without an index: a triangle that crosses is cut, and the rim goes straight down by `column` to a floor.
 * Keeps position and normal.
 * @param left_out  whether a triangle is, by its middle and normal
 */
export function cutBelow(geometry, y, column, left_out = () => false) {
  const flat = geometry.toNonIndexed();
  const { position, normal } = flat.attributes;
  const corner = (i) => [...new THREE.Vector3().fromBufferAttribute(position, i), ...new THREE.Vector3().fromBufferAttribute(normal, i)];
  const crossing = (a, b) => {
    const t = (y - a[1]) / (b[1] - a[1]);
    return a.map((value, k) => (k === 1 ? y : value + t * (b[k] - value)));
  };
  const kept = [];
  const rim = [];
  for (let i = 0; i < position.count; i += 3) {
    const triangle = [corner(i), corner(i + 1), corner(i + 2)];
    if (left_out(triangle[0].map((_, k) => (triangle[0][k] + triangle[1][k] + triangle[2][k]) / 3))) continue;
    const polygon = triangle.flatMap((a, k) => {
      const b = triangle[(k + 1) % 3];
      return [...(a[1] > y ? [a] : []), ...(a[1] > y !== b[1] > y ? [crossing(a, b)] : [])];
    });
    for (let k = 2; k < polygon.length; k++) kept.push(polygon[0], polygon[k - 1], polygon[k]);
    const cut = polygon.filter((p) => p[1] === y);
    if (cut.length === 2) rim.push(polygon[0] === cut[0] && polygon.at(-1) === cut[1] ? cut.reverse() : cut);
  }
  const middle = [0, 1, 2].map((k) => rim.reduce((sum, [a]) => sum + a[k], 0) / rim.length);
  const wall = (p, height) => [p[0], height, p[2], ...new THREE.Vector3(p[0] - middle[0], 0, p[2] - middle[2]).normalize()];
  const floor = (p) => [p[0], y - column, p[2], 0, -1, 0];
  for (const [a, b] of rim) {
    kept.push(wall(a, y), wall(b, y - column), wall(b, y), wall(a, y), wall(a, y - column), wall(b, y - column));
    kept.push(floor(b), floor(a), floor(middle));
  }
  const result = new THREE.BufferGeometry();
  result.setAttribute("position", new THREE.Float32BufferAttribute(kept.flatMap((p) => p.slice(0, 3)), 3));
  result.setAttribute("normal", new THREE.Float32BufferAttribute(kept.flatMap((p) => p.slice(3)), 3));
  return result;
}
