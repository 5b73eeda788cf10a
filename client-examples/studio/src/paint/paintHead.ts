import * as THREE from "three";
import type { HeadBall } from "../model/HeadBall";
import { bakedGeometry } from "./bakedGeometry";
import { cornersWithin } from "./cornersWithin";
import { outlineOf } from "./outlineOf";
import type { PaintedHead } from "./PaintedHead";
import { Palette } from "./Palette";
import { surfaceOf } from "./surfaceOf";
import { thinnedMesh } from "./thinnedMesh";
import { weldedMesh } from "./weldedMesh";

const kLineBehind = 0.04; // of the head's radius
const kScalp = 1.8; // of the head's radius: what is further away is no place for roots
const kMostVertices = 200_000; // of a scalp, and as many triangles: the contract's

/** The parts of a geometry that its materials paint: first corner and number of corners. */
function rangesOf(mesh: THREE.Mesh): { material: THREE.Material; start: number; count: number }[] {
  const whole = { start: 0, count: Infinity };
  if (!Array.isArray(mesh.material)) return [{ material: mesh.material, ...whole }];
  const materials = mesh.material;
  return mesh.geometry.groups.flatMap(({ start, count, materialIndex = 0 }) => {
    const material = materials[materialIndex];
    return material ? [{ material, start, count }] : [];
  });
}

/**
 * A head from a file that a person brought, painted flat: pictures and colors stay, a file without any becomes skin, and all is outlined.
 * Bones and morphs are applied as they stand; nothing is moved or scaled. Hair may grow on all that is near the head.
 * @param object  is left as it is and not disposed of
 * @param ballOf  finds the head among corners (x, y, z of three for every triangle); without it, all is head
 * @throws RangeError if there is no triangle in it
 */
export function paintHead(object: THREE.Object3D, ballOf?: (corners: ArrayLike<number>) => HeadBall): PaintedHead {
  object.updateWorldMatrix(true, true);
  const group = new THREE.Group();
  const geometries: THREE.BufferGeometry[] = [];
  const palette = new Palette(object);
  object.traverseVisible((node) => {
    if (!(node instanceof THREE.Mesh)) return;
    const ranges = rangesOf(node as THREE.Mesh).filter(({ material }) => palette.isSeen(material));
    if (ranges.length === 0) return;
    const baked = bakedGeometry(node as THREE.Mesh);
    geometries.push(baked);
    for (const { material, start, count } of ranges) {
      const part = count === Infinity ? baked : baked.clone();
      if (part !== baked) part.setDrawRange(start, count);
      const mesh = new THREE.Mesh(part, palette.paint(material));
      mesh.castShadow = mesh.receiveShadow = true;
      group.add(mesh);
    }
    if (ranges.every(({ material }) => palette.isOutlined(material))) group.add(outlineOf(new THREE.Mesh(baked), palette.line));
  });
  const surface = surfaceOf(geometries);
  const free = (): void => {
    group.traverse((node) => node instanceof THREE.Mesh && (node.geometry as THREE.BufferGeometry).dispose());
    palette.dispose();
    (surface.material as THREE.Material).dispose();
    surface.geometry.dispose();
  };
  const corners = surface.geometry.getAttribute("position").array;
  if (corners.length === 0) {
    free();
    throw new RangeError("there is no triangle in this file");
  }
  const ball = ballOf?.(corners);
  palette.setBehind(kLineBehind * (ball?.radius ?? 0.1));
  const scalp = thinnedMesh(weldedMesh(ball ? cornersWithin(corners, ball.center, kScalp * ball.radius) : corners), kMostVertices);
  return {
    group,
    surface,
    scalp,
    setScalpTones() {}, // its scalp is its own
    dispose: free,
  };
}
