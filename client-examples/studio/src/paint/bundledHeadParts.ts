import * as THREE from "three";
import { cutBelow } from "./cutBelow";
import { drawnProfile } from "./drawnProfile";
import { isInMouth } from "./isInMouth";

/** One part of the head in the hair's frame: to paint, with flat normals, and to outline, with its own. */
export interface HeadPart {
  readonly painted: THREE.BufferGeometry;
  readonly outlined: THREE.BufferGeometry;
}

// In the file's frame, metres from the floor.
const kCrown = 1.6659;
const kNeck = { cut: 1.42, column: 0.045, share: 0.66, slimmed: [1.43, 1.49], front: 0.07 } as const;
const kSkull = { middle: [0, 1.545, 0.062], half: [0.085, 0.17, 0.105], above: [1.425, 1.455] } as const;
const kFace = { y: 1.492, half: [0.072, 0.083] } as const; // the drawn one's middle and half its sides

// From the file's frame to the hair's: the head's center is the origin, the crown at 0.1.
const kScale = [1.2, 1.04, 1.02] as const;
const kPosition = [0, 0.1 - kScale[1] * kCrown, -0.058] as const;

/** Left, bottom, right, top of the drawn face in the hair's frame, metres. */
export const kFaceBox: readonly [number, number, number, number] = [
  -kFace.half[0] * kScale[0] + kPosition[0],
  (kFace.y - kFace.half[1]) * kScale[1] + kPosition[1],
  kFace.half[0] * kScale[0] + kPosition[0],
  (kFace.y + kFace.half[1]) * kScale[1] + kPosition[1],
];

/** Nothing is drawn on what lies farther back, metres in the hair's frame: the jaw, which is narrow enough for the cheeks' blush. */
export const kFaceFront = 0.046;

const axisOfNeck = (y: number): number => 0.03 + 0.1 * (y - 1.4);

/** Cuts neck and chin to the widths that hair of these proportions is drawn for. */
function slimNeck(geometry: THREE.BufferGeometry): void {
  const position = geometry.getAttribute("position");
  for (let i = 0; i < position.count; i++) {
    const scale = THREE.MathUtils.lerp(kNeck.share, 1, THREE.MathUtils.smoothstep(position.getY(i), ...kNeck.slimmed));
    position.setX(i, scale * position.getX(i));
    if (position.getZ(i) < kNeck.front) position.setZ(i, kNeck.front + scale * (position.getZ(i) - kNeck.front));
  }
}

/** Normals of an egg on a column: a painter leaves out the relief of lids, lips and cheeks. */
function flattenRelief(geometry: THREE.BufferGeometry): void {
  const position = geometry.getAttribute("position");
  const normal = geometry.getAttribute("normal");
  const at = new THREE.Vector3();
  const skull = new THREE.Vector3();
  const neck = new THREE.Vector3();
  for (let i = 0; i < position.count; i++) {
    at.fromBufferAttribute(position, i);
    const part = (k: 0 | 1 | 2): number => (at.getComponent(k) - kSkull.middle[k]) / kSkull.half[k] ** 2;
    skull.set(part(0), part(1), part(2)).normalize();
    neck.set(at.x, 0, at.z - axisOfNeck(at.y)).normalize();
    neck.lerp(skull, THREE.MathUtils.smoothstep(at.y, ...kSkull.above)).normalize();
    normal.setXYZ(i, neck.x, neck.y, neck.z);
  }
}

/**
 * The parts of the bundled head, cut at the neck and placed.
 * @param scene  of tests/data/heads/mpfb_head_base.glb
 * @return  by the names of their materials: skin, scalp, eyes
 */
export function bundledHeadParts(scene: THREE.Object3D): Map<string, HeadPart> {
  const parts = new Map<string, HeadPart>();
  const place = new THREE.Matrix4().makeScale(...kScale).setPosition(...kPosition);
  scene.traverse((node) => {
    if (!(node instanceof THREE.Mesh)) return;
    const { geometry, material } = node as THREE.Mesh<THREE.BufferGeometry, THREE.Material>;
    const painted = cutBelow(geometry, kNeck.cut, kNeck.column);
    const outlined = cutBelow(geometry, kNeck.cut, kNeck.column, ([x, y, z]) => isInMouth(x, y, z));
    for (const part of [painted, outlined]) {
      drawnProfile(part);
      slimNeck(part);
    }
    flattenRelief(painted);
    for (const part of [painted, outlined]) part.applyMatrix4(place);
    parts.set(material.name, { painted, outlined });
    geometry.dispose();
    material.dispose();
  });
  return parts;
}
