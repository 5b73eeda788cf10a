import * as THREE from "three";
import type { CharacterMotionAnswer, Rotation } from "../api/contract";
import { headBall } from "../bring/headBall";
import { loadModel, type LoadedModel } from "../bring/loadModel";
import type { HeadBall } from "../model/HeadBall";
import type { Guest } from "../stage/Guest";
import type { BroughtCharacter } from "./BroughtCharacter";
import type { CharacterPoses } from "./CharacterLoader";
import { ChainLines } from "./ChainLines";
import { cornersOf } from "./cornersOf";
import { paintCharacter } from "./paintCharacter";

const kMargin = 1.34; // of its height, around it: the buttons above and the note below leave it free
const kLeastBall = 0.1; // of what is shown: the wind must be seen on a whole figure

/** A character in the scene, its chains turned as a picture says. */
export class CharacterView implements Guest {
  readonly group = new THREE.Group();
  private readonly rest = new Map<THREE.Object3D, THREE.Quaternion>();
  private readonly unpaint: () => void;
  private poses: CharacterPoses = { limited: null, smooth: null };

  private constructor(private readonly model: LoadedModel, private readonly lines: ChainLines | null, readonly ball: HeadBall, readonly middle: THREE.Vector3, readonly height: number, readonly front: Guest["front"]) {
    this.unpaint = paintCharacter(model.scene);
    this.group.add(model.scene);
    if (!lines) return;
    model.scene.visible = false; // what lines it has do not bend
    this.group.add(lines.lines);
  }

  /** @throws Error if the file cannot be shown, RangeError if there is nothing in it */
  static async load({ bytes, found }: BroughtCharacter): Promise<CharacterView> {
    const model = await loadModel(bytes);
    model.scene.updateWorldMatrix(true, true);
    let corners = cornersOf(model.scene);
    const lines = corners.length > 0 ? null : new ChainLines(found.chains, model.nodes);
    if (lines) corners = lines.positions.array;
    if (corners.length === 0) {
      lines?.dispose();
      model.dispose();
      throw new RangeError("there is nothing in this file");
    }
    const box = new THREE.Box3().setFromArray(corners);
    const size = box.getSize(new THREE.Vector3());
    const height = kMargin * Math.max(size.y, 0.8 * size.x);
    const head = headBall(corners, found.head?.center ?? null);
    const ball = { ...head, radius: Math.max(head.radius, kLeastBall * height) };
    return new CharacterView(model, lines, ball, box.getCenter(new THREE.Vector3()), height, [0, 0, found.facing === "-Z" ? -1 : 1]);
  }

  setPoses(poses: CharacterPoses): void {
    this.poses = poses;
    for (const [node, turn] of this.rest) node.quaternion.copy(turn); // those that move no more stand as they did
    this.lines?.update();
  }

  showPicture(picture: number): void {
    const { limited } = this.poses;
    if (limited) this.pose(limited, picture % limited.pictures.length, 0);
  }

  showSmooth(part: number): void {
    const { smooth } = this.poses;
    if (!smooth) return;
    const place = part * smooth.pictures.length;
    this.pose(smooth, Math.floor(place) % smooth.pictures.length, place % 1);
  }

  dispose(): void {
    this.unpaint();
    this.lines?.dispose();
    this.model.dispose();
  }

  /** @param share  of the picture after it, 0..1 */
  private pose({ chains, pictures }: CharacterMotionAnswer, picture: number, share: number): void {
    const [now, next] = [pictures[picture]!, pictures[(picture + 1) % pictures.length]!];
    const [turn, after] = [new THREE.Quaternion(), new THREE.Quaternion()];
    const read = (into: THREE.Quaternion, rotation: Rotation) => into.set(rotation[0], rotation[1], rotation[2], rotation[3]);
    chains.forEach(({ bones }, i) => bones.forEach(({ node: index }, bone) => {
      const node = this.model.nodes.get(index);
      if (!node) return;
      if (!this.rest.has(node)) this.rest.set(node, node.quaternion.clone());
      read(turn, now.chains[i]!.rotations[bone]!);
      if (share > 0) turn.slerp(read(after, next.chains[i]!.rotations[bone]!), share);
      node.quaternion.copy(turn);
    }));
    this.lines?.update();
  }
}
