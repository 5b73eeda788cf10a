import * as THREE from "three";
import { addSmoothedNormals } from "./addSmoothedNormals";

/** The hull of a mesh, skinned or not, to hang beside it. It shares the geometry; rays pass through it. */
export function outlineOf(mesh: THREE.Mesh, material: THREE.Material): THREE.Mesh {
  addSmoothedNormals(mesh.geometry);
  const hull = mesh instanceof THREE.SkinnedMesh ? new THREE.SkinnedMesh(mesh.geometry, material) : new THREE.Mesh(mesh.geometry, material);
  if (mesh instanceof THREE.SkinnedMesh && hull instanceof THREE.SkinnedMesh) hull.bind(mesh.skeleton, mesh.bindMatrix);
  hull.applyMatrix4(mesh.matrix);
  hull.frustumCulled = false;
  hull.raycast = () => {};
  return hull;
}
