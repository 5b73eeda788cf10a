// Plays every flip book of a directory in three.js beside the skinned clip of the same hair.
//
//   node flip_book.mjs DIRECTORY
//
// A file NAME_flip_book.glb is compared with NAME.glb, whose tufts are merged, and NAME.json, the answer to the same
// request. At each frame exactly the right picture is to be seen, and its vertices are where skinning takes them.
// Exit code 0 or 1.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

import { AnimationMixer, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

import { distance, lengthOf, secondsOf, shownPictures } from "./chains.mjs";
import { Checks } from "./checks.mjs";
import { readGlb } from "./glb.mjs";

const TOLERANCE = 1e-5; // of the shortest chain's length
const LOOPS = 3;

async function load(path) {
  const { scene, animations } = await new GLTFLoader().parseAsync(readGlb(path).bytes, "");
  const mixer = new AnimationMixer(scene);
  mixer.clipAction(animations[0]).play();
  const meshes = [];
  scene.traverse((object) => object.isMesh && meshes.push(object));
  return { scene, mixer, meshes };
}

/** @returns {string} what is wrong with the pictures that are to be seen, or "" */
function visibilityFault({ mixer, meshes }, { schedule }) {
  const shown = shownPictures(schedule);
  for (let k = 0; k < LOOPS * shown.length; k += 1) {
    for (const part of [0, 0.5, 0.99]) {
      mixer.setTime(secondsOf(k + part, schedule.fps));
      const scales = meshes.map(({ scale }) => scale.toArray());
      const wrong = scales.findIndex((scale, n) => scale.some((axis) => axis !== (n === shown[k % shown.length] ? 1 : 0)));
      if (wrong >= 0) return `picture ${wrong} has the scale ${scales[wrong]} at frame ${k + part}`;
    }
  }
  return "";
}

/** The largest distance between a picture's vertices and those that three.js skins, metres. */
function vertexError(page, skinned) {
  const places = page.geometry.getAttribute("position");
  let largest = places.count === skinned.geometry.getAttribute("position").count ? 0 : Infinity;
  for (let v = 0; v < places.count; v += 1) {
    const expected = skinned.getVertexPosition(v, new Vector3()).applyMatrix4(skinned.matrixWorld).toArray();
    largest = Math.max(largest, distance(new Vector3().fromBufferAttribute(places, v).toArray(), expected));
  }
  return largest;
}

const [directory] = process.argv.slice(2);
const checks = new Checks();
let books = 0;
for (const file of readdirSync(directory).filter((entry) => entry.endsWith("_flip_book.glb")).sort()) {
  const name = file.replace("_flip_book.glb", "");
  const [glb, json] = ["glb", "json"].map((word) => join(directory, `${name}.${word}`));
  checks.add(`${file}: a clip to compare with`, existsSync(glb) && existsSync(json) ? "" : "is missing");
  if (!existsSync(glb) || !existsSync(json)) continue;
  books += 1;
  const answer = JSON.parse(readFileSync(json, "utf8"));
  const [book, skinned] = [await load(join(directory, file)), await load(glb)];
  const { pictures, starts, fps } = answer.schedule;
  checks.add(`${file}: meshes`, book.meshes.length === pictures && skinned.meshes.length === 1 ? "" : `${book.meshes.length} and ${skinned.meshes.length}`);
  checks.add(`${file}: ${LOOPS} loops`, visibilityFault(book, answer));
  const whole = Math.min(...answer.pictures[0].chains.map(({ positions }) => lengthOf(positions)));
  for (let n = 0; n < pictures; n += 1) {
    skinned.mixer.setTime(secondsOf(starts[n] + 0.5, fps));
    skinned.scene.updateMatrixWorld(true);
    skinned.meshes[0].skeleton.update();
    const off = vertexError(book.meshes[n], skinned.meshes[0]) / whole;
    checks.add(`${file}: vertices of picture ${n}`, off <= TOLERANCE ? "" : `${off} of the shortest chain's length off`);
  }
}
console.log(`${books} flip books played`);
checks.finish();
