// The head under the hair: MakeHuman's, painted flat, with a drawn face.
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { cutBelow } from "./cut.mjs";
import { faceTexture } from "./face.mjs";
import { outlineMaterial, outlineOf } from "./outline.mjs";
import { kSkin } from "./paint.mjs";
import { toonMaterial } from "./toon.mjs";

// In the file's frame, metres from the floor.
const kNeck = { cut: 1.42, column: 0.045, share: 0.66, slimmed: [1.43, 1.49], front: 0.07, axis: (y) => 0.03 + 0.1 * (y - 1.4) };
const kSkull = { middle: [0, 1.545, 0.062], half: [0.085, 0.17, 0.105], above: [1.425, 1.455] };
const kFace = { y: 1.492, half: [0.072, 0.083] }; // the drawn one's middle and half its sides
const kLineBehind = 0.045; // metres: the chin stands off the neck by more, lips and lids off the face by less

/** The bag behind the lips, and where they touch: the outline would draw a line between them. */
const inMouth = ([x, y, z, , up]) => Math.abs(x) < 0.032 && y > 1.45 && y < 1.515 && z > 0.04
  && (z < 0.15 - Math.abs(x) || (y > 1.462 && y < 1.492 && Math.abs(up) > 0.5));

/** Cuts neck and chin to the widths that hair of these proportions is drawn for. */
function slimNeck({ attributes: { position } }) {
  const { share, slimmed, front } = kNeck;
  for (let i = 0; i < position.count; i++) {
    const scale = THREE.MathUtils.lerp(share, 1, THREE.MathUtils.smoothstep(position.getY(i), ...slimmed));
    position.setX(i, scale * position.getX(i));
    if (position.getZ(i) < front) position.setZ(i, front + scale * (position.getZ(i) - front));
  }
}

/** Normals of an egg on a column: a painter leaves out the relief of lids, lips and cheeks. */
function flattenRelief({ attributes: { position, normal } }) {
  for (let i = 0; i < position.count; i++) {
    const at = new THREE.Vector3().fromBufferAttribute(position, i);
    const skull = new THREE.Vector3(...kSkull.middle.map((m, k) => (at.getComponent(k) - m) / kSkull.half[k] ** 2)).normalize();
    const neck = new THREE.Vector3(at.x, 0, at.z - kNeck.axis(at.y)).normalize();
    normal.setXYZ(i, ...neck.lerp(skull, THREE.MathUtils.smoothstep(at.y, ...kSkull.above)).normalize());
  }
}

let loading = null;

/** By name (skin, scalp, eyes): the geometry to paint and the one to outline. */
async function loadParts() {
  const parts = {};
  (await new GLTFLoader().loadAsync("/heads/mpfb_head_base.glb")).scene.traverse((node) => {
    if (!node.isMesh) return;
    const painted = cutBelow(node.geometry, kNeck.cut, kNeck.column);
    const outlined = cutBelow(node.geometry, kNeck.cut, kNeck.column, inMouth);
    slimNeck(painted);
    slimNeck(outlined);
    flattenRelief(painted);
    parts[node.material.name] = { painted, outlined };
  });
  return parts;
}

/**
 * @param place  position and scale (three numbers), from the file's frame to the hair's
 * @param look  of the face; see faceTexture
 * @param scalp  its tones; the material is in userData.scalp
 */
export async function makeHead({ position, scale }, look, scalp) {
  loading ??= loadParts();
  const corner = (side) => [side * kFace.half[0] * scale[0] + position[0], (kFace.y + side * kFace.half[1]) * scale[1] + position[1]];
  const light = [0.45, 0.4, 0.9];
  const skin = toonMaterial({ tones: kSkin.tones, light, decal: { texture: faceTexture(look), box: [...corner(-1), ...corner(1)] } });
  const paint = { skin, eyes: skin, scalp: toonMaterial({ tones: scalp, light }) };
  const line = outlineMaterial(kSkin.line, kSkin.pixels, kLineBehind);
  const head = new THREE.Group();
  for (const [name, { painted, outlined }] of Object.entries(await loading)) {
    const mesh = new THREE.Mesh(painted, paint[name]);
    mesh.castShadow = mesh.receiveShadow = true;
    head.add(mesh);
    if (name !== "eyes") head.add(outlineOf(new THREE.Mesh(outlined), line));
  }
  head.userData.scalp = paint.scalp;
  head.scale.set(...scale);
  head.position.set(...position);
  return head;
}
