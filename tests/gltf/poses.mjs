// Reads every BVH, USD and VMD file of a directory with other people's readers and compares each frame with the
// service's JSON answer: the same joints must stand in the same places, whatever the format calls a rotation.
//
//   node poses.mjs DIRECTORY
//
// A file NAME.bvh, NAME.usda or NAME.vmd is compared with NAME.json, the answer to the same request, and with the names
// and the rest pose of NAME.glb. Exit code 0 or 1.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

import mmd from "mmd-parser";
import { Vector3 } from "three";
import { BVHLoader } from "three/addons/loaders/BVHLoader.js";
import { USDLoader } from "three/addons/loaders/USDLoader.js";

import { add, chainNodes, distance, lengthOf, product, restPoses, shownPictures, subtract, turned } from "./chains.mjs";
import { Checks } from "./checks.mjs";
import { readGlb } from "./glb.mjs";

const TOLERANCE = 1e-5; // of the chain's length, as in playback.mjs
const KEY_BYTES = 111;

/** The chains of a GLB: the names and the rest places of their nodes. */
function restChains(glb, answer) {
  const rest = restPoses(glb.json);
  const lengths = answer.pictures[0].chains.map((chain) => chain.rotations.length);
  return chainNodes(glb.json, lengths).map((nodes) => ({
    names: nodes.slice(0, -1).map((node) => glb.json.nodes[node].name),
    places: nodes.map((node) => rest.get(node).position),
  }));
}

/** How far places are from those of a picture, as a share of each chain's length. @param places  per chain and node */
function farthest(places, picture) {
  let largest = 0;
  for (const [c, { positions }] of picture.chains.entries()) {
    for (const [i, place] of places[c].entries()) largest = Math.max(largest, distance(place, positions[i]) / lengthOf(positions));
  }
  return largest;
}

/** The first fault of all frames. @param placesAt  the places of all nodes at frame k */
function frameFault(answer, placesAt) {
  for (const [frame, picture] of shownPictures(answer.schedule).entries()) {
    const off = farthest(placesAt(frame), answer.pictures[picture]);
    if (!(off <= TOLERANCE)) return `${off} of the chain's length off at frame ${frame}`;
  }
  return "";
}

/** Places by bones without rest rotations. @param turnOf  a bone's rotation relative to its parent, by its name */
function placesOf({ names, places }, turnOf) {
  const posed = [places[0]];
  let turn = [0, 0, 0, 1];
  for (const [i, name] of names.entries()) {
    turn = product(turn, turnOf(name));
    posed.push(add(posed[i], turned(turn, subtract(places[i + 1], places[i]))));
  }
  return posed;
}

/** What the JSON answer's own turns say. */
function turnsFault(chains, answer) {
  return frameFault(answer, (frame) => {
    const picture = answer.pictures[shownPictures(answer.schedule)[frame]];
    return chains.map(({ places }, c) => places.reduce((posed, place, i) =>
      [...posed, i === 0 ? place : add(posed[i - 1], turned(picture.chains[c].turns[i - 1], subtract(place, places[i - 1])))], []));
  });
}

function bvhFault(bytes, chains, answer) {
  const text = bytes.toString("ascii");
  const { frames, period } = answer.schedule;
  const seconds = Number(/^Frame Time: (.*)$/m.exec(text)[1]);
  if (Math.abs(seconds * frames - period) > 1e-9 * frames) return `frames of ${seconds} seconds`;
  if (text.split("\n").slice(-2)[0].split(" ").length !== 6 + 3 * chains.flatMap(({ names }) => names).length) return "a line without all its numbers";
  const { skeleton, clip } = new BVHLoader().parse(text);
  if (skeleton.bones[0].name !== "hair_root") return `the root is called ${skeleton.bones[0].name}`;
  const bones = skeleton.bones.slice(1);
  const wanted = chains.flatMap(({ names }) => [...names, "ENDSITE"]);
  if (JSON.stringify(bones.map((bone) => bone.name)) !== JSON.stringify(wanted)) return "other joints than the GLB";
  const tracks = new Map(clip.tracks.map((track) => [track.name, track]));
  if ([...tracks.values()].some((track) => track.times.length !== frames)) return "not a line for each frame";
  return frameFault(answer, (frame) => {
    for (const bone of skeleton.bones) {
      const rotation = tracks.get(`${bone.name}.quaternion`);
      const position = tracks.get(`${bone.name}.position`);
      if (rotation) bone.quaternion.fromArray(rotation.values, 4 * frame);
      if (position) bone.position.fromArray(position.values, 3 * frame);
    }
    skeleton.bones[0].updateMatrixWorld(true);
    let next = 0;
    return chains.map(({ places }) => places.map(() => new Vector3().setFromMatrixPosition(bones[next++].matrixWorld).toArray()));
  });
}

/** The lists of numbers that an attribute of a USD layer holds. */
const numberLists = (text, attribute, pattern) =>
  [...new RegExp(`${attribute} = \\[(.*)\\]`).exec(text)[1].matchAll(pattern)].map((match) => match[0].match(/-?[\d.]+(?:e[-+]?\d+)?/g).map(Number));

function usdaFault(bytes, chains, answer) {
  const text = bytes.toString("ascii");
  const joints = JSON.parse(/uniform token\[\] joints = (.*)/.exec(text)[1]);
  const wanted = chains.flatMap(({ names }) => names.map((_, i) => names.slice(0, i + 1).join("/")));
  if (JSON.stringify(joints) !== JSON.stringify(wanted)) return "other joints than the GLB";
  const bind = numberLists(text, "bindTransforms", /\( \(.*?\) \)/g);
  const places = chains.flatMap((chain) => chain.places.slice(0, -1));
  const misplaced = bind.findIndex((matrix, j) => distance(matrix.slice(12, 15), places[j]) > 1e-6 * Math.max(1, ...places[j].map(Math.abs)));
  if (bind.length !== joints.length || misplaced >= 0) return `joint ${misplaced} is bound elsewhere`;
  const translations = numberLists(text, "translations", /\(.*?\)/g);
  const { tracks, duration } = new USDLoader().parse(text).animations[0];
  if (Math.abs(duration - answer.schedule.period) > 1e-6) return `a clip of ${duration} seconds`;
  const rotations = new Map(tracks.map((track) => [track.name, track]));
  const { starts, pictures } = answer.schedule;
  const seconds = answer.schedule.period / answer.schedule.frames;
  for (const track of tracks) {
    if (track.times.length !== 2 * pictures + 1) return `${track.name} has ${track.times.length} samples`;
    if (starts.some((start, n) => Math.abs(track.times[2 * n] - start * seconds) > 1e-6)) return `${track.name} does not begin where pictures do`;
    if (track.values.some((part, k) => k % 8 < 4 && k < 8 * pictures && part !== track.values[k + 4])) return `${track.name} does not hold its pictures`;
    if (track.values.slice(-4).some((part, k) => part !== track.values[k])) return `${track.name} does not close the loop`;
  }
  const shown = shownPictures(answer.schedule);
  return frameFault(answer, (frame) => {
    let next = 0;
    return chains.map(({ names }) => {
      let [rotation, place] = [[0, 0, 0, 1], [0, 0, 0]];
      return names.map((name) => {
        place = add(place, turned(rotation, translations[next++]));
        rotation = product(rotation, [...rotations.get(`${name}.quaternion`).values.subarray(8 * shown[frame], 8 * shown[frame] + 4)]);
        return place;
      });
    });
  });
}

/** The rotation at a frame; between keys only where both are the same, since nothing may be seen to change. */
function heldRotation(keys, frame) {
  const after = keys.findIndex((key) => key.frameNum >= frame);
  const [before, next] = [keys[Math.max(0, after - 1)], keys[after]];
  if (next.frameNum === frame) return next.rotation;
  if (next.rotation.some((part, k) => part !== before.rotation[k])) throw new Error(`${next.boneName} changes during frame ${frame}`);
  return next.rotation;
}

function vmdFault(bytes, chains, answer) {
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const { metadata, motions } = new mmd.Parser().parseVmd(buffer, true); // into glTF's axes
  if (bytes.length !== 74 + KEY_BYTES * metadata.motionCount || motions.length !== metadata.motionCount) return `${bytes.length} bytes of ${metadata.motionCount} keys`;
  const keys = Map.groupBy ? Map.groupBy(motions, (key) => key.boneName) : groupByBone(motions);
  const wanted = chains.flatMap(({ names }) => names);
  if (JSON.stringify([...keys.keys()]) !== JSON.stringify(wanted)) return "other bones than the GLB";
  for (let at = 54; at < bytes.length - 20; at += KEY_BYTES) {
    if (bytes[at + 49] !== 0x63 || bytes[at + 50] !== 0x0f) return "physics is on";
    if (bytes.subarray(at + 19, at + 31).some((byte) => byte !== 0)) return "a bone is moved";
  }
  const { frames } = answer.schedule;
  for (const own of keys.values()) {
    const last = own.at(-1);
    if (last.frameNum !== frames || last.rotation.some((part, k) => part !== own[0].rotation[k])) return `${last.boneName} does not close the loop`;
  }
  return frameFault(answer, (frame) => chains.map((chain) => placesOf(chain, (name) => heldRotation(keys.get(name), frame))));
}

function groupByBone(motions) {
  const groups = new Map();
  for (const key of motions) groups.set(key.boneName, [...(groups.get(key.boneName) ?? []), key]);
  return groups;
}

const FAULTS = { bvh: bvhFault, usda: usdaFault, vmd: vmdFault };
const [directory] = process.argv.slice(2);
const checks = new Checks();
const counts = { bvh: 0, usda: 0, vmd: 0 };
const chainsOf = new Map();
for (const file of readdirSync(directory).sort()) {
  const [name, ending] = file.split(/\.(?=[^.]*$)/);
  const [glb, json] = ["glb", "json"].map((word) => join(directory, `${name}.${word}`));
  if (!(ending in FAULTS) || !existsSync(glb) || !existsSync(json)) continue;
  const answer = JSON.parse(readFileSync(json, "utf8"));
  if (!chainsOf.has(name)) {
    chainsOf.set(name, restChains(readGlb(glb), answer));
    checks.add(`${name}: turns`, turnsFault(chainsOf.get(name), answer));
  }
  counts[ending] += 1;
  try {
    checks.add(file, FAULTS[ending](readFileSync(join(directory, file)), chainsOf.get(name), answer));
  } catch (error) {
    checks.add(file, String(error));
  }
}
console.log(`poses of ${Object.entries(counts).map(([word, count]) => `${count} ${word}`).join(", ")} files`);
checks.finish();
