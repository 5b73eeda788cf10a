// W2's clip: the travelling wave along chains, as tracks of three.js and as samplers of glTF-Transform, with STEP keys.
import { Document, NodeIO } from "@gltf-transform/core";
import { AnimationClip, Bone, InterpolateDiscrete, Quaternion, QuaternionKeyframeTrack, Scene, Vector3 } from "three";
import { exportGlb } from "./pack.mjs";

const AXIS = new Vector3(0, 0, 1); // the wind blows along +X, up is +Y
const [AMPLITUDE, SPATIAL_PERIOD, LIGHTNESS] = [0.8, 1, 1.2]; // a, k, s, as the service has them

/** Furukawa and Nakata 2018, equation (1). */
const height = (x, phase) => (-AMPLITUDE / LIGHTNESS) * (x / Math.PI) * (Math.cos(x / SPATIAL_PERIOD - phase) + 1 / LIGHTNESS);

function placesAlong(chain) {
  const x = [0];
  for (let i = 1; i < chain.length; i++) x.push(x[i - 1] + Math.hypot(chain[i][0] - chain[i - 1][0], chain[i][1] - chain[i - 1][1], chain[i][2] - chain[i - 1][2]));
  return x.map((place) => (Math.PI * place) / x.at(-1));
}

/** Bone angles of every picture, their mean taken out: [picture][bone]. */
function anglesOf(chain, pictures) {
  const x = placesAlong(chain);
  const angles = Array.from({ length: pictures }, (_, n) => {
    const phase = (2 * Math.PI * n) / pictures;
    return x.slice(1).map((place, i) => Math.atan2(height(place, phase) - height(x[i], phase), place - x[i]));
  });
  for (let i = 0; i + 1 < chain.length; i++) {
    const mean = angles.reduce((sum, picture) => sum + picture[i], 0) / pictures;
    for (const picture of angles) picture[i] -= mean;
  }
  return angles;
}

/** Keys of every bone, the first one once more at the end: x y z w after each other. */
function keysOf(chain, pictures) {
  const keys = chain.slice(1).map(() => new Float32Array(4 * (pictures + 1)));
  const [global, parent, local] = [new Quaternion(), new Quaternion(), new Quaternion()];
  anglesOf(chain, pictures).forEach((picture, n) => {
    parent.identity();
    picture.forEach((angle, i) => {
      global.setFromAxisAngle(AXIS, angle);
      local.copy(parent).invert().multiply(global).normalize().toArray(keys[i], 4 * n);
      parent.copy(global);
    });
  });
  for (const values of keys) values.copyWithin(4 * pictures, 0, 4);
  return keys;
}

const timesOf = (pictures, hold) => Float32Array.from({ length: pictures + 1 }, (_, n) => (n * hold) / 24);
const offset = (chain, i) => (i ? chain[i].map((value, axis) => value - chain[i - 1][axis]) : chain[0]);

/** @returns  ArrayBuffer */
export function threeClip(chains, pictures, hold) {
  const scene = new Scene();
  const times = timesOf(pictures, hold);
  const tracks = [];
  chains.forEach((chain, c) => {
    const bones = chain.map((_, i) => {
      const bone = new Bone();
      bone.name = `lock_${c}_${i}`;
      bone.position.fromArray(offset(chain, i));
      return bone;
    });
    scene.add(bones[0]);
    bones.slice(1).forEach((bone, i) => bones[i].add(bone));
    keysOf(chain, pictures).forEach((keys, i) => tracks.push(new QuaternionKeyframeTrack(`${bones[i].name}.quaternion`, times, keys, InterpolateDiscrete)));
  });
  return exportGlb(scene, [new AnimationClip("breeze", -1, tracks)]);
}

/** @returns  Uint8Array */
export function transformClip(chains, pictures, hold) {
  const document = new Document();
  const buffer = document.createBuffer();
  const scene = document.createScene();
  const animation = document.createAnimation("breeze");
  const times = document.createAccessor().setType("SCALAR").setArray(timesOf(pictures, hold)).setBuffer(buffer);
  chains.forEach((chain, c) => {
    const nodes = chain.map((_, i) => document.createNode(`lock_${c}_${i}`).setTranslation(offset(chain, i)));
    scene.addChild(nodes[0]);
    nodes.slice(1).forEach((node, i) => nodes[i].addChild(node));
    keysOf(chain, pictures).forEach((keys, i) => {
      const values = document.createAccessor().setType("VEC4").setArray(keys).setBuffer(buffer);
      const sampler = document.createAnimationSampler().setInput(times).setOutput(values).setInterpolation("STEP");
      animation.addSampler(sampler).addChannel(document.createAnimationChannel().setTargetNode(nodes[i]).setTargetPath("rotation").setSampler(sampler));
    });
  });
  return new NodeIO().writeBinary(document);
}
