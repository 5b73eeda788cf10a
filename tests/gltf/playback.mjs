// Plays every animated GLB of a directory in three.js and compares each frame with the service's JSON answer.
//
//   node playback.mjs DIRECTORY [LOOPS]
//
// A file NAME.glb is played if NAME.json, the answer to the same request, stands beside it. Every .glb's nodes and
// meshes are checked. Exit code 0 or 1.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

import { AnimationMixer, InterpolateLinear, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

import { add, chainNodes, distance, inverse, lengthOf, objectsByNode, product, restPoses, secondsOf, shownPictures, subtract, turned } from "./chains.mjs";
import { Checks } from "./checks.mjs";
import { readGlb } from "./glb.mjs";
import { meshFault, nodeFault } from "./invariants.mjs";

const MOST_COMPARISONS = 4e6; // joints times frames per file and way of playing; larger files play fewer loops, at least 3
const TOLERANCE = 1e-5; // of the chain's length, 2.5 micrometres on a hair of 25 cm; in metres where it has none

/** Counts joints that show another picture than they should. `seek(k)` brings the clip to frame k. */
function countWrong(joints, shown, loops, seek, tolerance = 0) {
  let wrong = 0;
  const differs = (a, b) => !(Math.abs(a - b) <= tolerance);
  for (let k = 0; k < loops * shown.length; k += 1) {
    seek(k);
    const picture = shown[k % shown.length];
    for (const { quaternion: q, pictures } of joints) {
      const at = 4 * picture;
      if (differs(q.x, pictures[at]) || differs(q.y, pictures[at + 1]) || differs(q.z, pictures[at + 2]) || differs(q.w, pictures[at + 3])) wrong += 1;
    }
  }
  return wrong;
}

/** What an importer makes of a clip that knows no steps. @returns {string} what is wrong, or "" */
function linearFault(name, gltf, joints, shown, fps) {
  const clip = gltf.animations[0].clone();
  for (const track of clip.tracks) track.setInterpolation(InterpolateLinear);
  const mixer = new AnimationMixer(gltf.scene);
  const action = mixer.clipAction(clip).play();
  // A clip with a key per frame is right on each frame only; one that is held in between, too.
  const wrong = (name.endsWith("_held") ? [0, 0.5, 0.99] : [0])
    .map((part) => countWrong(joints, shown, 3, (k) => mixer.setTime(secondsOf(k + part, fps)), 1e-5))
    .reduce((sum, count) => sum + count);
  action.stop();
  return wrong ? `${wrong} wrong` : "";
}

/** Each joint's object, and its rotations in all pictures as the JSON answer has them. */
function jointsOf(objects, chains, answer) {
  return chains.flatMap((nodes, c) =>
    nodes.map((node, i) => {
      const { quaternion } = objects[node];
      const rotations = answer.pictures.map((picture) => picture.chains[c].rotations[i]);
      // A tip has no keys, so its file says q where the answer, whose first picture has w >= 0, may say -q: one rotation.
      const isTurned = i === nodes.length - 1 && quaternion.toArray().every((part, k) => part === -Math.fround(rotations[0][k]));
      return { quaternion, pictures: Float32Array.from(rotations.flat(), (part) => (isTurned ? -part : part)) };
    }));
}

/** The largest distance between three.js' node positions and the answer's, as a share of the chain's length. */
function positionError(objects, chains, picture) {
  let largest = 0;
  for (const [c, nodes] of chains.entries()) {
    const { positions } = picture.chains[c];
    const whole = lengthOf(positions);
    for (const [i, node] of nodes.entries()) {
      largest = Math.max(largest, distance(new Vector3().setFromMatrixPosition(objects[node].matrixWorld).toArray(), positions[i]) / whole);
    }
  }
  return largest;
}

/** The rigid motions of all joints from rest to a picture, from the answer's rotations and positions alone. */
function jointMotions(json, chains, picture) {
  const rest = restPoses(json);
  const motions = new Map();
  for (const [c, nodes] of chains.entries()) {
    const { rotations, positions } = picture.chains[c];
    const parent = json.nodes.findIndex((node) => node.children?.includes(nodes[0]));
    let posed = rest.get(parent).rotation;
    const whole = lengthOf(positions);
    for (const [i, node] of nodes.entries()) {
      posed = product(posed, rotations[i]);
      motions.set(node, { turn: product(posed, inverse(rest.get(node).rotation)), from: rest.get(node).position, to: positions[i], whole });
    }
  }
  return motions;
}

/** The largest distance between three.js' skinned vertices and our own skinning, as a share of the chain's length. */
function skinError(glb, objects, chains, picture) {
  const motions = jointMotions(glb.json, chains, picture);
  let largest = 0;
  for (const [index, { mesh, skin }] of glb.json.nodes.entries()) {
    if (mesh === undefined) continue;
    const { attributes } = glb.json.meshes[mesh].primitives[0];
    const [positions, joints, weights] = ["POSITION", "JOINTS_0", "WEIGHTS_0"].map((name) => glb.data(attributes[name]));
    const object = objects[index];
    object.skeleton.update();
    for (let v = 0; v < positions.length / 3; v += 1) {
      const rest = [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]];
      let expected = [0, 0, 0];
      let whole = Infinity;
      for (let k = 0; k < 4; k += 1) {
        const weight = weights[4 * v + k];
        if (weight === 0) continue;
        const motion = motions.get(glb.json.skins[skin].joints[joints[4 * v + k]]);
        expected = add(expected, add(motion.to, turned(motion.turn, subtract(rest, motion.from))).map((part) => weight * part));
        whole = Math.min(whole, motion.whole);
      }
      const shown = object.getVertexPosition(v, new Vector3()).applyMatrix4(object.matrixWorld);
      largest = Math.max(largest, distance(shown.toArray(), expected) / whole);
    }
  }
  return largest;
}

async function play(name, glb, answer, mostLoops, checks) {
  const gltf = await new GLTFLoader().parseAsync(glb.bytes, "");
  const { schedule } = gltf.asset.extras.tuftwave;
  checks.add(`${name}: the schedule in extras is the answer's`, JSON.stringify(sorted(schedule)) === JSON.stringify(sorted(answer.schedule)) ? "" : JSON.stringify(schedule));
  const shown = shownPictures(schedule);
  const objects = objectsByNode(gltf);
  const chains = chainNodes(glb.json, answer.pictures[0].chains.map((chain) => chain.rotations.length));
  const joints = jointsOf(objects, chains, answer);
  const loops = Math.min(mostLoops, Math.max(3, Math.floor(MOST_COMPARISONS / (joints.length * shown.length))));

  const mixer = new AnimationMixer(gltf.scene);
  mixer.clipAction(gltf.animations[0]).play();
  const sought = countWrong(joints, shown, loops, (k) => mixer.setTime(secondsOf(k, schedule.fps)));
  checks.add(`${name}: ${loops} loops by seeking`, sought ? `${sought} wrong of ${joints.length * loops * shown.length}` : "");
  mixer.setTime(0);
  const step = secondsOf(1, schedule.fps);
  const stepped = countWrong(joints, shown, loops, (k) => mixer.update(k === 0 ? 0 : step));
  checks.add(`${name}: ${loops} loops by stepping`, stepped ? `${stepped} wrong of ${joints.length * loops * shown.length}` : "");

  const between = countWrong(joints, shown, 3, (k) => mixer.setTime(secondsOf(k + 0.5, schedule.fps)));
  checks.add(`${name}: 3 loops between frames`, between ? `${between} wrong of ${joints.length * 3 * shown.length}` : "");
  if (/_(held|per_frame)$/.test(name)) checks.add(`${name}: by an importer without steps`, linearFault(name, gltf, joints, shown, schedule.fps));

  for (const picture of new Set([0, Math.floor(schedule.pictures / 2)])) {
    mixer.setTime(secondsOf(schedule.starts[picture] + 0.5, schedule.fps));
    gltf.scene.updateMatrixWorld(true);
    const off = positionError(objects, chains, answer.pictures[picture]);
    checks.add(`${name}: node positions of picture ${picture}`, off > TOLERANCE ? `${off} of the chain's length off` : "");
    const skinOff = skinError(glb, objects, chains, answer.pictures[picture]);
    checks.add(`${name}: skinned vertices of picture ${picture}`, skinOff > TOLERANCE ? `${skinOff} of the chain's length off` : "");
  }
  return loops * shown.length;
}

/** Extras are sorted by key in a file, and not in an answer. */
const sorted = (object) => Object.fromEntries(Object.entries(object).sort(([a], [b]) => (a < b ? -1 : 1)));

const [directory, loops = "200"] = process.argv.slice(2);
const checks = new Checks();
let files = 0;
let frames = 0;
for (const file of readdirSync(directory).filter((entry) => entry.endsWith(".glb") && !entry.endsWith("_packed.glb")).sort()) {
  const name = file.slice(0, -4);
  const glb = readGlb(join(directory, file));
  checks.add(`${name}: nodes`, nodeFault(glb));
  for (const mesh of glb.json.meshes ?? []) checks.add(`${name}: mesh ${mesh.name}`, meshFault(glb, mesh));
  const answer = join(directory, `${name}.json`);
  if (!existsSync(answer)) continue;
  files += 1;
  frames += await play(name, glb, JSON.parse(readFileSync(answer, "utf8")), Number(loops), checks);
}
console.log(`${files} clips played, ${frames} frames each by seeking and by stepping`);
checks.finish();
