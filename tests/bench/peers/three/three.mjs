// W1, W2 and W3 by three.js, glTF-Transform and VRM spring bones.
//
//   node tests/bench/peers/three/three.mjs FOLDER      with w1.json and w2.json
import { readFileSync } from "node:fs";
import { Mesh, MeshStandardMaterial, Scene } from "three";
import { bakeLastCycle } from "../../springs/bake.mjs";
import { VRM1_DEFAULTS } from "../../springs/workloads.mjs";
import { threeClip, transformClip } from "./clips.mjs";
import { measure, measureCold, printValue } from "./measure.mjs";
import { exportGlb, transformGlb } from "./pack.mjs";
import { leanMerged, leanSplit, stockMerged } from "./tubes.mjs";

const [folder] = process.argv.slice(2);
if (!folder) {
  console.error("usage: node three.mjs FOLDER");
  process.exit(2);
}
const read = (name) => JSON.parse(readFileSync(`${folder}/${name}`, "utf8"));
const strokes = read("w1.json").tufts.map(({ points }) => points);
const chains = read("w2.json").chains;
const lines = chains.map(({ nodes }) => nodes);
const springs = { head: [0, 0, 0], chains: chains.map((chain) => ({ ...chain, settings: VRM1_DEFAULTS })) };

function sceneOf(geometries) {
  const scene = new Scene();
  const material = new MeshStandardMaterial();
  for (const geometry of geometries) scene.add(new Mesh(geometry, material));
  return scene;
}

await measureCold("w3/three_vrm", () => bakeLastCycle(springs, 1, 24, 1));
await measure("w1/three", () => exportGlb(sceneOf([stockMerged(strokes)])));
await measure("w1/gltf_transform", () => transformGlb([stockMerged(strokes)]));
await measure("w1/three_lean_merged", () => exportGlb(sceneOf([leanMerged(strokes)])));
await measure("w1/three_lean_split", () => exportGlb(sceneOf(leanSplit(strokes))));
await measure("w2/three", () => threeClip(lines, 12, 2));
await measure("w2/gltf_transform", () => transformClip(lines, 12, 2));
await measure("w3/three_vrm_warm", () => bakeLastCycle(springs, 1, 24, 1));
printValue("w1_bytes/three", (await exportGlb(sceneOf([leanMerged(strokes)]))).byteLength, "B");
printValue("w1_bytes/three_lean_split", (await exportGlb(sceneOf(leanSplit(strokes)))).byteLength, "B");
printValue("w2_bytes/three", (await threeClip(lines, 12, 2)).byteLength, "B");
