import * as THREE from "three";

/** One mesh of loose triangles from several geometries, all in the world's frame. It is not meant to be drawn. */
export function surfaceOf(geometries: readonly THREE.BufferGeometry[]): THREE.Mesh<THREE.BufferGeometry> {
  const loose = geometries.map((geometry) => (geometry.index ? geometry.toNonIndexed() : geometry).getAttribute("position").array);
  const positions = new Float32Array(loose.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of loose) {
    positions.set(part, at);
    at += part.length;
  }
  const merged = new THREE.BufferGeometry();
  merged.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  return new THREE.Mesh(merged, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
}
