import * as THREE from "three";
import { outlineOf } from "./outlineOf";
import type { TuftMaterials } from "./tuftMaterials";

const kVeilOrder = -1; // before every tuft that is not solid
const kLineOrder = 1; // after it: within a ghost, no line shines through

/**
 * Tufts as they stand in the scene: their surface, with the outline and the veil as children that rays pass through.
 * @param geometry  position, normal, joints, weights, mark; gets `smoothed` if it has none; the caller disposes of it
 */
export function tuftMesh(geometry: THREE.BufferGeometry, materials: TuftMaterials): THREE.Mesh {
  const mesh = new THREE.Mesh(geometry, materials.toon);
  mesh.customDepthMaterial = materials.depth;
  mesh.castShadow = mesh.receiveShadow = true;
  mesh.frustumCulled = false; // posed, it leaves the box of its geometry
  const hull = outlineOf(mesh, materials.outline);
  hull.renderOrder = kLineOrder;
  const veil = new THREE.Mesh(geometry, materials.veil);
  veil.renderOrder = kVeilOrder;
  veil.frustumCulled = false;
  veil.raycast = () => {};
  mesh.add(hull, veil);
  return mesh;
}
