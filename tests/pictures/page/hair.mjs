// Moving hair from the service: the GLB, painted, and its pictures.
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { outlineMaterial } from "../../../client-examples/studio/src/paint/outlineMaterial";
import { outlineOf } from "../../../client-examples/studio/src/paint/outlineOf";
import { toonMaterial } from "../../../client-examples/studio/src/paint/toonMaterial";

const answers = new Map();

async function fetchHair(name) {
  const answer = await fetch(`/hair/${name}.glb`);
  if (!answer.ok) throw new Error(`/hair/${name}.glb: ${await answer.text()}`);
  return answer.arrayBuffer();
}

/**
 * The hair of a request by its name. The same name with other paint is asked for once.
 * @param paint  tones, shine, band, roundness, line, pixels; see toonMaterial and outlineMaterial
 * @return  group; tufts, their number; schedule, null where the hair is still; showPicture(j); material and line, the paint
 */
export async function loadHair(name, paint) {
  if (!answers.has(name)) answers.set(name, fetchHair(name));
  const gltf = await new GLTFLoader().parseAsync(await answers.get(name), "");
  const { schedule = null, hairstyle } = gltf.asset.extras.tuftwave;
  const material = toonMaterial({ center: hairstyle.head.center, ...paint });
  const line = outlineMaterial(paint.line, paint.pixels);
  const meshes = [];
  gltf.scene.traverse((node) => node.isMesh && meshes.push(node));
  for (const mesh of meshes) {
    mesh.material = material;
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.frustumCulled = false;
    mesh.parent.add(outlineOf(mesh, line));
  }
  const mixer = new THREE.AnimationMixer(gltf.scene);
  for (const clip of gltf.animations) mixer.clipAction(clip).play();
  const showPicture = (picture) => schedule && mixer.setTime((schedule.starts[picture] + 0.5) / schedule.fps);
  showPicture(0);
  return { group: gltf.scene, tufts: meshes.length, schedule, showPicture, material, line };
}
