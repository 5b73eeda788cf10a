// Reads every packed GLB of a directory with three.js and its MeshoptDecoder and compares it with the plain one.
//
//   node packed.mjs DIRECTORY
//
// NAME_packed.glb is the answer to the same request as NAME.glb. Every vertex must stand where it did, as its node or its
// bones have it, at the start and in the middle of the clip, and no file may have got larger. Exit code 0 or 1.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

import { AnimationMixer, Vector3 } from "three";
import { MeshoptDecoder } from "three/addons/libs/meshopt_decoder.module.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

import { Checks } from "./checks.mjs";

// Of the longest edge of a mesh's box: half a 65,535th along each axis; where it bends, also what a 255th of a weight does.
const STILL = 1.33e-5;
const BENT = 1e-3;

/** Vertices of a file, mesh by mesh, as they are seen at a share of its clip, if it has one. */
async function placesOf(path, share) {
  const bytes = readFileSync(path);
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
  const { scene, animations } = await loader.parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength), "");
  if (animations.length > 0) {
    const mixer = new AnimationMixer(scene);
    mixer.clipAction(animations[0]).play();
    mixer.setTime(share * animations[0].duration);
  }
  scene.updateMatrixWorld(true);
  const meshes = [];
  scene.traverse((object) => {
    if (!object.isMesh) return;
    if (object.isSkinnedMesh) object.skeleton.update();
    const { count } = object.geometry.attributes.position;
    meshes.push(Array.from({ length: count }, (_, i) => object.getVertexPosition(i, new Vector3()).applyMatrix4(object.matrixWorld)));
  });
  return { meshes, isBent: animations.length > 0 };
}

function edgeOf(vertices) {
  const spans = ["x", "y", "z"].map((axis) => {
    const [least, most] = vertices.reduce(([a, b], v) => [Math.min(a, v[axis]), Math.max(b, v[axis])], [Infinity, -Infinity]);
    return most - least;
  });
  return Math.max(...spans);
}

async function faultOf(plainPath, packedPath) {
  if (readFileSync(packedPath).length > readFileSync(plainPath).length) return "is larger than the plain file";
  for (const share of [0, 0.5]) {
    const [plain, packed] = await Promise.all([placesOf(plainPath, share), placesOf(packedPath, share)]);
    if (plain.meshes.length !== packed.meshes.length) return `${packed.meshes.length} meshes, not ${plain.meshes.length}`;
    for (const [m, vertices] of plain.meshes.entries()) {
      const edge = edgeOf(vertices);
      const far = vertices.reduce((most, place, i) => Math.max(most, place.distanceTo(packed.meshes[m][i])), 0) / edge;
      const size = vertices.reduce((most, place) => Math.max(most, place.length()), 0);
      const floats = (4 * size) / 2 ** 23 / edge; // far from the origin floats know no better
      if (!(far <= (plain.isBent ? BENT : STILL) + floats)) return `a vertex of mesh ${m} is off by ${far} of ${edge} m`;
    }
  }
  return "";
}

const [directory] = process.argv.slice(2);
const checks = new Checks();
await MeshoptDecoder.ready;
for (const file of readdirSync(directory).filter((name) => name.endsWith("_packed.glb")).sort()) {
  try {
    checks.add(file, await faultOf(join(directory, file.replace("_packed", "")), join(directory, file)));
  } catch (error) {
    checks.add(file, String(error));
  }
}
checks.finish();
