import * as THREE from "three";
import { isInMouth } from "./isInMouth";

// In the file's frame of the bundled head, metres from the floor. The face without its features: z as a polynomial of u = x² and
// t = y - 1.5, fitted to the 300 vertices of brow, cheeks and chin (rms 1.7 mm).
const kFit = { one: 0.15382, t: 0.025624, tt: -1.7787, ttt: 9.5121, u: -8.3988, ut: 143.23, utt: -1183.4, uu: -1002.3, uut: -6998.5 };
const kNose = { tip: 1.478, height: 0.0075, half: 0.0085, above: 0.017, below: 0.0045 }; // where the drawn face has it: under the real one
const kAcross = [0.042, 0.066] as const; // from the middle: all changed to that, nothing from that on
const kBelow = [1.445, 1.456] as const;
const kAbove = [1.572, 1.585] as const;
const kDeep = 0.045; // behind the face: what lies deeper is the back of the head
const kPlate = 0.002; // behind the face: the mouth's bag becomes a plate there, or one would see through where the lips part
const kStep = 1e-4; // for slopes

function depthAt(x: number, y: number): number {
  const [u, t] = [x * x, y - 1.5];
  const middle = kFit.one + t * (kFit.t + t * (kFit.tt + t * kFit.ttt));
  const face = middle + u * (kFit.u + t * (kFit.ut + t * kFit.utt) + u * (kFit.uu + t * kFit.uut));
  const high = (y - kNose.tip) / (y > kNose.tip ? kNose.above : kNose.below);
  return face + kNose.height * Math.exp(-u / kNose.half ** 2 - high * high);
}

function shareAt(x: number, y: number): number {
  const { smoothstep } = THREE.MathUtils;
  return (1 - smoothstep(Math.abs(x), ...kAcross)) * smoothstep(y, ...kBelow) * (1 - smoothstep(y, ...kAbove));
}

/**
 * Smooths the bundled head's face to one that eyes and mouth are drawn on: sockets, nostrils and lips go, a small nose comes, so that
 * the outline is clean from the side too. Changes position and normal.
 */
export function drawnProfile(geometry: THREE.BufferGeometry): void {
  const position = geometry.getAttribute("position");
  const normal = geometry.getAttribute("normal");
  const turned = new THREE.Vector3();
  for (let i = 0; i < position.count; i++) {
    const [x, y, z] = [position.getX(i), position.getY(i), position.getZ(i)];
    const share = shareAt(x, y);
    const depth = depthAt(x, y);
    if (isInMouth(x, y, z)) {
      position.setZ(i, depth - kPlate);
      continue;
    }
    if (share === 0 || z < depth - kDeep) continue;
    position.setZ(i, THREE.MathUtils.lerp(z, depth, share));
    const slope = [(depthAt(x + kStep, y) - depth) / kStep, (depthAt(x, y + kStep) - depth) / kStep] as const;
    turned.set(-slope[0], -slope[1], 1).normalize();
    turned.lerp(new THREE.Vector3().fromBufferAttribute(normal, i), 1 - share).normalize();
    normal.setXYZ(i, turned.x, turned.y, turned.z);
  }
}
