// Compares characters that came back with those that were posted, and plays what was added.
//
//   node uploads.mjs DIRECTORY
//
// NAME.in.glb was posted, NAME.glb came back, NAME.json has the same poses. The validator must say of the second what it
// says of the first, and nothing else; in three.js the new clip must show exactly its pictures on exactly its frames,
// with every bone where the JSON has it. Exit code 0 or 1.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

import validator from "gltf-validator";
import { AnimationMixer, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

import { distance, lengthOf, objectsByNode, secondsOf, shownPictures } from "./chains.mjs";
import { Checks } from "./checks.mjs";
import { readGlb } from "./glb.mjs";

const LOOPS = 50;
const TOLERANCE = 1e-5; // of the chain's length; a root is as far from the origin as five lengths, and floats know it as well

async function messagesOf(path) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(path)), { maxIssues: 0, writeTimestamp: false });
  return new Set(report.issues.messages.map(({ code, pointer, severity }) => `${severity} ${code} ${pointer}`));
}

/** What the validator says of the answer only; what springs=remove leaves unused may be remarked on. */
async function newMessages(directory, name) {
  const [before, after] = await Promise.all([`${name}.in.glb`, `${name}.glb`].map((file) => messagesOf(join(directory, file))));
  return [...after].filter((message) => !before.has(message)).join(", ");
}

/** The bytes of a GLB whose pictures are left out, since Node cannot decode them. */
function withoutImages({ json, bytes }) {
  const { images, textures, materials, ...kept } = json;
  for (const mesh of kept.meshes) for (const primitive of mesh.primitives) delete primitive.material;
  const text = new TextEncoder().encode(JSON.stringify(kept));
  const padded = new Uint8Array(Math.ceil(text.length / 4) * 4).fill(0x20);
  padded.set(text);
  const rest = new Uint8Array(bytes).subarray(20 + new DataView(bytes).getUint32(12, true));
  const file = new Uint8Array(20 + padded.length + rest.length);
  const header = new DataView(file.buffer);
  [0x46546c67, 2, file.length, padded.length, 0x4e4f534a].forEach((word, i) => header.setUint32(4 * i, word, true));
  file.set(padded, 20);
  file.set(rest, 20 + padded.length);
  return file.buffer;
}

/** The bones that turn, each with its rotations in all pictures as float32. */
function bonesOf(objects, answer) {
  return answer.chains.flatMap((chain, c) =>
    chain.bones.map(({ node }, i) => ({
      quaternion: objects[node].quaternion,
      pictures: answer.pictures.map((picture) => Float32Array.from(picture.chains[c].rotations[i])),
    })));
}

function countWrong(bones, shown, seek) {
  let wrong = 0;
  for (let k = 0; k < LOOPS * shown.length; k += 1) {
    seek(k);
    for (const { quaternion, pictures } of bones) {
      const expected = pictures[shown[k % shown.length]];
      if (quaternion.toArray().some((part, i) => part !== expected[i])) wrong += 1;
    }
  }
  return wrong ? `${wrong} wrong of ${bones.length * LOOPS * shown.length}` : "";
}

/** The largest distance between three.js' bones and the answer's, as a share of the chain's length; tips without a node have none. */
function positionError(objects, answer, picture) {
  let largest = 0;
  for (const [c, { bones, tip }] of answer.chains.entries()) {
    const { positions } = answer.pictures[picture].chains[c];
    const nodes = bones.map(({ node }) => node).concat(tip.node ?? []);
    for (const [i, node] of nodes.entries()) {
      const place = new Vector3().setFromMatrixPosition(objects[node].matrixWorld).toArray();
      largest = Math.max(largest, distance(place, positions[i]) / lengthOf(positions));
    }
  }
  return largest;
}

async function play(directory, name, checks) {
  const answer = JSON.parse(readFileSync(join(directory, `${name}.json`), "utf8"));
  const gltf = await new GLTFLoader().parseAsync(withoutImages(readGlb(join(directory, `${name}.glb`))), "");
  const clip = gltf.animations.at(-1);
  checks.add(`${name}: the clip's schedule`, JSON.stringify(clip.userData) === JSON.stringify(answer.schedule) ? "" : JSON.stringify(clip.userData));
  const { schedule } = answer;
  const shown = shownPictures(schedule);
  const objects = objectsByNode(gltf);
  const bones = bonesOf(objects, answer);
  const mixer = new AnimationMixer(gltf.scene);
  mixer.clipAction(clip).play();
  if (!name.endsWith(".held")) { // linear: on a frame's first instant it is between two float32s
    checks.add(`${name}: ${LOOPS} loops by seeking`, countWrong(bones, shown, (k) => mixer.setTime(secondsOf(k, schedule.fps))));
    mixer.setTime(0);
    checks.add(`${name}: ${LOOPS} loops by stepping`, countWrong(bones, shown, (k) => mixer.update(k === 0 ? 0 : secondsOf(1, schedule.fps))));
  }
  for (let picture = 0; picture < schedule.pictures; picture += 1) {
    mixer.setTime(secondsOf(schedule.starts[picture] + 0.5, schedule.fps));
    gltf.scene.updateMatrixWorld(true);
    const off = positionError(objects, answer, picture);
    checks.add(`${name}: bones of picture ${picture}`, off > TOLERANCE ? `${off} of the chain's length off` : "");
  }
}

const [directory] = process.argv.slice(2);
const checks = new Checks();
const names = readdirSync(directory).filter((file) => file.endsWith(".in.glb")).map((file) => file.slice(0, -7)).sort();
for (const name of names) {
  const remarks = await newMessages(directory, name);
  checks.add(`${name}: the validator`, remarks);
  await play(directory, name, checks);
}
console.log(`${names.length} characters played, ${LOOPS} loops each by seeking and by stepping`);
checks.finish();
