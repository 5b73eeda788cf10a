// The strokes of a request as a person drew them: lines with their points.
import * as THREE from "three";
import { toonMaterial } from "../../../client-examples/studio/src/paint/toonMaterial";

const kThread = 0.0009; // metres
const kBead = 0.0021;

const plain = (color) => toonMaterial({ tones: [color, color, color] });

/** @param tufts  the request's; @param colors  line, point, root */
export function makeStrokes(tufts, colors) {
  const group = new THREE.Group();
  const materials = { line: plain(colors.line), point: plain(colors.point), root: plain(colors.root) };
  const bead = new THREE.SphereGeometry(kBead, 12, 8);
  for (const { points } of tufts) {
    const at = points.map((point) => new THREE.Vector3(...point));
    for (let i = 0; i + 1 < at.length; i++) {
      group.add(new THREE.Mesh(new THREE.TubeGeometry(new THREE.LineCurve3(at[i], at[i + 1]), 1, kThread, 6), materials.line));
    }
    for (const [i, point] of at.entries()) {
      const mesh = new THREE.Mesh(bead, i ? materials.point : materials.root);
      mesh.position.copy(point);
      group.add(mesh);
    }
  }
  return group;
}
