import * as THREE from "three";
import type { CharacterChain } from "../api/contract";

const kInk = "#8a5348";

/** Chains as lines along their bones, for files that have no surface. */
export class ChainLines {
  readonly lines = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: kInk }));
  /** Each segment's ends: a node and a place in its frame. */
  private readonly ends: (readonly [THREE.Object3D, THREE.Vector3])[] = [];

  /** @param nodes  by their index, at rest and up to date (updateWorldMatrix) */
  constructor(chains: readonly CharacterChain[], nodes: ReadonlyMap<number, THREE.Object3D>) {
    for (const { bones, tip } of chains) {
      const places = [...bones.map(({ position }) => position), tip.position];
      bones.forEach(({ node: index }, i) => {
        const node = nodes.get(index);
        if (!node) return;
        const inNode = (place: readonly [number, number, number]) => node.worldToLocal(new THREE.Vector3(...place));
        this.ends.push([node, inNode(places[i]!)], [node, inNode(places[i + 1]!)]);
      });
    }
    this.lines.geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * this.ends.length), 3));
    this.lines.frustumCulled = false;
    this.update();
  }

  /** Where the ends of all segments are; x, y, z. */
  get positions(): THREE.BufferAttribute {
    return this.lines.geometry.getAttribute("position") as THREE.BufferAttribute;
  }

  /** The nodes have turned. */
  update(): void {
    const place = new THREE.Vector3();
    this.ends.forEach(([node, end], i) => {
      node.updateWorldMatrix(true, false);
      this.positions.setXYZ(i, ...place.copy(end).applyMatrix4(node.matrixWorld).toArray());
    });
    this.positions.needsUpdate = true;
  }

  dispose(): void {
    this.lines.geometry.dispose();
    this.lines.material.dispose();
  }
}
