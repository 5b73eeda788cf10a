import * as THREE from "three";

/**
 * A mesh as it stands now, bones and morphs applied, in the world's frame: position, normal, and uv if it has any, without an index.
 * The mesh and its parents must be up to date (updateWorldMatrix).
 */
export function bakedGeometry(mesh: THREE.Mesh): THREE.BufferGeometry {
  const { geometry } = mesh;
  const count = geometry.getAttribute("position").count;
  const standing = new Float32Array(3 * count);
  const at = new THREE.Vector3();
  for (let i = 0; i < count; i++) mesh.getVertexPosition(i, at).applyMatrix4(mesh.matrixWorld).toArray(standing, 3 * i);
  const baked = new THREE.BufferGeometry();
  baked.setAttribute("position", new THREE.BufferAttribute(standing, 3));
  const uv = geometry.getAttribute("uv");
  if (uv) baked.setAttribute("uv", uv.clone());
  const posed = mesh instanceof THREE.SkinnedMesh || (mesh.morphTargetInfluences ?? []).some((share) => share !== 0);
  const normal = geometry.getAttribute("normal");
  if (normal && !posed) {
    const turned = normal.clone();
    turned.applyNormalMatrix(new THREE.Matrix3().getNormalMatrix(mesh.matrixWorld));
    baked.setAttribute("normal", turned);
  }
  baked.setIndex(geometry.index);
  if (!baked.hasAttribute("normal")) baked.computeVertexNormals();
  if (!baked.index) return baked;
  const loose = baked.toNonIndexed();
  baked.dispose();
  return loose;
}
