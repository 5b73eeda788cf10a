import * as THREE from "three";
import { smoothedNormals } from "./smoothedNormals";

/** Gives a geometry the attribute `smoothed` that outlineMaterial needs, if it has none. */
export function addSmoothedNormals(geometry: THREE.BufferGeometry): void {
  if (geometry.hasAttribute("smoothed")) return;
  const numbers = (name: string): ArrayLike<number> => {
    const attribute = geometry.getAttribute(name);
    const plain = attribute instanceof THREE.BufferAttribute && attribute.itemSize === 3 && !attribute.normalized;
    if (plain) return attribute.array;
    return Array.from({ length: attribute.count }, (_, i) => [attribute.getX(i), attribute.getY(i), attribute.getZ(i)]).flat();
  };
  geometry.setAttribute("smoothed", new THREE.BufferAttribute(smoothedNormals(numbers("position"), numbers("normal")), 3));
}
