// A whole character that came back from the service with a clip: its own textures, flat, and an ink line around it.
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { outlineMaterial } from "../../../client-examples/studio/src/paint/outlineMaterial";
import { outlineOf } from "../../../client-examples/studio/src/paint/outlineOf";
import { toonMaterial } from "../../../client-examples/studio/src/paint/toonMaterial";

const kLine = "#3a2c3f";

/** A texture flat, as it was painted; a plain color in three tones. */
function painted({ map, color, alphaTest, transparent, side }) {
  if (!map) return toonMaterial({ tones: [0.72, 0.88, 1].map((share) => `#${color.clone().multiplyScalar(share).getHexString()}`) });
  map.colorSpace = THREE.NoColorSpace; // colors are what the painter mixed
  return new THREE.MeshBasicMaterial({ map, alphaTest: transparent ? 0.5 : alphaTest, side });
}

/**
 * @param name  as in uploads.mjs
 * @param faces_minus_z  turn it around, as VRM 0.x wants it
 * @return  group; schedule; showPicture(j)
 */
export async function loadUploaded(name, { faces_minus_z = false } = {}) {
  const answer = await fetch(`/hair/${name}.glb`);
  if (!answer.ok) throw new Error(`/hair/${name}.glb: ${await answer.text()}`);
  const gltf = await new GLTFLoader().parseAsync(await answer.arrayBuffer(), "");
  const meshes = [];
  gltf.scene.traverse((node) => node.isMesh && meshes.push(node));
  const line = outlineMaterial(kLine, 0.9, 0.004);
  for (const mesh of meshes) {
    mesh.material = painted(mesh.material);
    mesh.frustumCulled = false;
    mesh.receiveShadow = false;
    if (mesh.isSkinnedMesh) mesh.parent.add(outlineOf(mesh, line));
  }
  const clip = gltf.animations.at(-1);
  const mixer = new THREE.AnimationMixer(gltf.scene);
  mixer.clipAction(clip).play();
  const schedule = clip.userData;
  const showPicture = (picture) => {
    mixer.setTime((schedule.starts[picture] + 0.5) / schedule.fps);
    gltf.scene.updateMatrixWorld(true);
  };
  showPicture(0);
  const group = new THREE.Group();
  group.add(gltf.scene);
  if (faces_minus_z) group.rotation.y = Math.PI;
  return { group, schedule, showPicture };
}
