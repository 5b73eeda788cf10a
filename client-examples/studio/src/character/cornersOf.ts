import * as THREE from "three";
import { bakedGeometry } from "../paint/bakedGeometry";
import { surfaceOf } from "../paint/surfaceOf";

/** All triangles of a loaded file as they stand: x, y, z of three corners for each. The object must be up to date (updateWorldMatrix). */
export function cornersOf(object: THREE.Object3D): ArrayLike<number> {
  const parts: THREE.BufferGeometry[] = [];
  object.traverseVisible((node) => node instanceof THREE.Mesh && parts.push(bakedGeometry(node as THREE.Mesh)));
  const surface = surfaceOf(parts);
  for (const geometry of [...parts, surface.geometry]) geometry.dispose();
  (surface.material as THREE.Material).dispose();
  return surface.geometry.getAttribute("position").array;
}
