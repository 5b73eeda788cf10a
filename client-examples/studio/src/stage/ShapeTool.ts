import { Plane, Vector3 } from "three";
import { roundPoint } from "../draw/roundPoint";
import { strokeLine } from "../draw/strokeLine";
import { changeTufts } from "../model/changeTufts";
import { headScale } from "../model/headScale";
import { insertPoint } from "../model/insertPoint";
import { movePoint } from "../model/movePoint";
import { removePoint } from "../model/removePoint";
import { removeTufts } from "../model/removeTufts";
import type { StudioTuft } from "../model/StudioDocument";
import type { Studio } from "../Studio";
import type { stageText } from "../text/stageText";
import { hoverTuft } from "./hoverTuft";
import type { Handle } from "./Overlay";
import type { Scene } from "./Scene";
import type { StagePointer } from "./StagePointer";
import type { Tool } from "./Tool";

const kNear_px = 14; // of the line, for a new point
const kNudge = 0.002; // metres per arrow key; with shift five times as far

/** Tufts that are there: selected, their points dragged, inserted, removed. */
export class ShapeTool implements Tool {
  private readonly endings: (() => void)[] = [];

  constructor(private readonly studio: Studio, private readonly scene: Scene, private readonly words: () => typeof stageText.en) {}

  start(): void {
    const show = () => this.show();
    this.endings.push(this.studio.history.current.changed(show), this.studio.point.changed(show), this.studio.selection.changed(() => this.mark()));
    this.mark();
  }

  stop(): void {
    for (const end of this.endings.splice(0)) end();
    this.scene.hair.hovered = null;
    this.scene.viewport.overlay.show([], []);
  }

  click({ ray, shift }: StagePointer): void {
    const id = this.scene.tuftAt(ray);
    const old = this.studio.selection.value;
    if (id === null) this.studio.select(shift ? old : []);
    else if (!shift) this.studio.select([id]);
    else this.studio.select(old.includes(id) ? old.filter((one) => one !== id) : [...old, id]);
  }

  doubleClick(pointer: StagePointer): void {
    const tuft = this.only;
    if (!tuft) return;
    const nearest = this.nearestOnLine(tuft, pointer);
    if (!nearest) return;
    this.studio.edit((document) => changeTufts(document, [tuft.id], (one) => insertPoint(one, nearest.place, roundPoint(nearest.point))));
    this.studio.point.value = nearest.place;
  }

  hover(pointer: StagePointer | null): void {
    hoverTuft(this.scene, pointer);
  }

  key(event: KeyboardEvent): boolean {
    if (event.key === "Delete" || event.key === "Backspace") {
      this.remove();
      return true;
    }
    if (event.key !== "Escape" || this.studio.selection.value.length === 0) return false;
    this.studio.select([]);
    return true;
  }

  /** The selected point, or if there is none the selected tufts. */
  private remove(): void {
    const { only, studio } = this;
    const point = studio.point.value;
    if (only && point !== null && point > 0) {
      studio.edit((document) => changeTufts(document, [only.id], (tuft) => removePoint(tuft, point)));
      studio.point.value = null;
    } else studio.edit((document) => removeTufts(document, studio.selection.value));
  }

  private get only(): StudioTuft | null {
    const { selected } = this.studio;
    return selected.length === 1 ? selected[0]! : null;
  }

  private mark(): void {
    this.scene.hair.selected = this.studio.selection.value;
    this.scene.viewport.invalidate();
    this.show();
  }

  private show(): void {
    const lines = this.studio.selected.map(({ points }) => ({ places: strokeLine(points), kind: "stroke" as const }));
    this.scene.viewport.overlay.show(this.only ? this.handlesOf(this.only) : [], lines);
  }

  private handlesOf(tuft: StudioTuft): Handle[] {
    const move = (i: number, place: Vector3) => this.studio.edit((document) => changeTufts(document, [tuft.id], (one) => movePoint(one, i, roundPoint(place))), `point ${tuft.id} ${i}`);
    return tuft.points.map((point, i) => ({
      place: new Vector3(...point),
      name: i === 0 ? this.words().root : this.words().point(i + 1),
      kind: i === 0 ? "root" : "point",
      isSelected: this.studio.point.value === i,
      onSelect: () => (this.studio.point.value = i),
      onSettle: () => this.studio.history.settle(),
      onDrag: (event) => {
        const ray = this.scene.viewport.rayAt(event.clientX, event.clientY);
        const place = i === 0 ? this.scene.head.value.hit(ray)?.point
          : ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(this.scene.viewport.view, new Vector3(...point)), new Vector3());
        if (place) move(i, place);
      },
      onKey: (event) => {
        if (!event.key.startsWith("Arrow")) return this.key(event);
        const place = new Vector3(...point).add(this.nudge(event));
        if (i > 0) move(i, place);
        return true;
      },
    }));
  }

  /** An arrow key as a way in the picture's plane. */
  private nudge({ key, shiftKey }: KeyboardEvent): Vector3 {
    const axis = new Vector3().setFromMatrixColumn(this.scene.viewport.camera.matrixWorld, key === "ArrowLeft" || key === "ArrowRight" ? 0 : 1);
    return axis.multiplyScalar((key === "ArrowLeft" || key === "ArrowDown" ? -1 : 1) * kNudge * headScale(this.scene.ball) * (shiftKey ? 5 : 1));
  }

  /** The place of the tuft's line nearest to the pointer, and which point it would be; null if none is near. */
  private nearestOnLine({ points }: StudioTuft, { x, y }: StagePointer): { place: number; point: Vector3 } | null {
    const { camera, size } = this.scene.viewport;
    const line = strokeLine(points);
    const perSegment = (line.length - 1) / (points.length - 1);
    let best: { place: number; point: Vector3 } | null = null;
    let nearest = kNear_px;
    line.forEach((point, i) => {
      const seen = point.clone().project(camera);
      const away = Math.sqrt((((seen.x + 1) / 2) * size.width - x) ** 2 + (((1 - seen.y) / 2) * size.height - y) ** 2);
      if (away >= nearest || i === 0 || i === line.length - 1) return;
      nearest = away;
      best = { place: Math.floor(i / perSegment) + 1, point };
    });
    return best;
  }
}
