import { Light, type Object3D } from "three";
import type { LoadedHair } from "../hair/HairLoader";
import { HairView } from "../hair/HairView";
import type { HairStage } from "../stage/HairStage";

/** Samples a side of a picture before it is shrunk; more than this many need hundreds of megabytes. */
const kMostSamples = 8192;
const kOversampling = 3;

export interface PictureLook {
  readonly withHead: boolean;
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
    this.view.show(hair);
  }

  /** @param picture  from 0 */
  paint(picture: number, { withHead, width, height }: PictureLook): HTMLCanvasElement {
    const { stage, camera } = this.stage.viewport;
    const stays = (node: Object3D) => node instanceof Light || (withHead && node === this.stage.headGroup);
    const hidden = stage.scene.children.filter((node) => node.visible && !stays(node));
    for (const node of hidden) node.visible = false;
    stage.scene.add(this.view.group);
    this.view.showPicture(picture, false);
    try {
      const samples = Math.max(1, Math.min(kOversampling, Math.floor(kMostSamples / Math.max(width, height))));
      return stage.snapshot(camera, width, height, samples);
    } finally {
      stage.scene.remove(this.view.group);
      for (const node of hidden) node.visible = true;
    }
  }

  dispose(): void {
    this.view.dispose();
  }
}
