import { Light, Mesh, type Object3D } from "three";
import type { LoadedHair } from "../hair/HairLoader";
import { HairView } from "../hair/HairView";
import type { HairStage } from "../stage/HairStage";

/** Samples a side of a picture before it is shrunk; more than this many need hundreds of megabytes. */
const kMostSamples = 8192;
const kOversampling = 3;

/** With the head; the hair alone; or the hair as far as the head does not hide it, to lie over another drawing of the head. */
export type PictureParts = "head" | "hair" | "cutOut";

export interface PictureLook {
  readonly parts: PictureParts;
  /** Pixels. */
  readonly width: number;
  readonly height: number;
}

/** Paints pictures of a cycle as the camera sees it now: the hair, the head if wanted, and nothing else. The page's own picture stays. */
export class CyclePainter {
  private readonly view: HairView;

  /** @param color  #rrggbb */
  constructor(private readonly stage: HairStage, hair: LoadedHair, color: string) {
    this.view = new HairView(color);
    this.view.setHead(stage.ball);
    this.view.show(hair);
  }

  /** @param picture  from 0 */
  paint(picture: number, { parts, width, height }: PictureLook): HTMLCanvasElement {
    const { stage, camera } = this.stage.viewport;
    const head = this.stage.headGroup;
    const stays = (node: Object3D) => node instanceof Light || (parts !== "hair" && node === head);
    const hidden = stage.scene.children.filter((node) => node.visible && !stays(node));
    const uncover = parts === "cutOut" ? cutOut(head) : () => {};
    for (const node of hidden) node.visible = false;
    stage.scene.add(this.view.group);
    this.view.showPicture(picture, false);
    try {
      const samples = Math.max(1, Math.min(kOversampling, Math.floor(kMostSamples / Math.max(width, height))));
      return stage.snapshot(camera, width, height, samples);
    } finally {
      stage.scene.remove(this.view.group);
      for (const node of hidden) node.visible = true;
      uncover();
    }
  }

  dispose(): void {
    this.view.dispose();
  }
}

/** Lets an object hide what is behind it without being seen itself: it is drawn first, as depth alone. @return  undoes that */
function cutOut(object: Object3D): () => void {
  const meshes: Mesh[] = [];
  object.traverse((node) => node instanceof Mesh && meshes.push(node as Mesh));
  const materials = new Set(meshes.flatMap(({ material }) => material).filter(({ colorWrite }) => colorWrite));
  const set = (colorWrite: boolean, orders: number) => {
    for (const material of materials) material.colorWrite = colorWrite;
    for (const mesh of meshes) mesh.renderOrder += orders;
  };
  set(false, -1);
  return () => set(true, 1);
}
