import * as THREE from "three";
import { cutBelow } from "./cutBelow";
import { drawnProfile } from "./drawnProfile";
import { type HeadPlace, kHeadPlace } from "./HeadPlace";
import { isInMouth } from "./isInMouth";

/** One part of the head in the hair's frame: to paint, with flat normals, and to outline, with its own. */
export interface HeadPart {
  readonly painted: THREE.BufferGeometry;
  readonly outlined: THREE.BufferGeometry;
}

// In the file's frame, metres from the floor.
const kNeck = { cut: 1.42, column: 0.045, share: 0.66, slimmed: [1.43, 1.49], front: 0.07 } as const;
const kSkull = { middle: [0, 1.545, 0.062], half: [0.085, 0.17, 0.105], above: [1.425, 1.455] } as const;

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
export function bundledHeadParts(scene: THREE.Object3D, { scale, position }: HeadPlace = kHeadPlace): Map<string, HeadPart> {
  const parts = new Map<string, HeadPart>();
  const place = new THREE.Matrix4().makeScale(...scale).setPosition(...position);
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
