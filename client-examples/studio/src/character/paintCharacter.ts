import * as THREE from "three";
import { outlineOf } from "../paint/outlineOf";
import { Palette } from "../paint/Palette";

const kLineBehind = 0.004; // metres

/** Gives a loaded character toon paint and outlines; its bones still pose it. @return  frees both */
export function paintCharacter(scene: THREE.Object3D): () => void {
  const palette = new Palette(scene);
  palette.setBehind(kLineBehind);
  const meshes: THREE.Mesh[] = [];
  scene.traverse((node) => node instanceof THREE.Mesh && meshes.push(node as THREE.Mesh));
  const plain = meshes.map((mesh) => [mesh, mesh.material] as const);
  for (const mesh of meshes) {
    const [material] = [mesh.material].flat(); // a file's meshes have one each
    if (!material) continue;
    mesh.visible = palette.isSeen(material);
    mesh.frustumCulled = false; // poses move it out of its box
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.material = palette.paint(material);
    if (!mesh.geometry.hasAttribute("normal")) mesh.geometry.computeVertexNormals();
    if (!mesh.visible || !palette.isOutlined(material)) continue;
    mesh.updateMatrix();
    mesh.parent?.add(outlineOf(mesh, palette.line));
  }
  return () => {
    for (const [mesh, material] of plain) mesh.material = material; // whose pictures are freed with the file
    palette.dispose();
  };
}
