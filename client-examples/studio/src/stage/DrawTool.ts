import { Vector3 } from "three";
import type { Tuft } from "../api/contract";
import { Freehand } from "../draw/Freehand";
import { roundPoint } from "../draw/roundPoint";
import { strokeLine } from "../draw/strokeLine";
import { addTufts } from "../model/addTufts";
import { headScale } from "../model/headScale";
import { mirrorTuft } from "../model/mirrorTuft";
import type { Studio } from "../Studio";
import type { stageText } from "../text/stageText";
import { DrawPlane } from "./DrawPlane";
import type { Handle, Line } from "./Overlay";
import type { Scene } from "./Scene";
import type { StagePointer } from "./StagePointer";
import type { Tool } from "./Tool";

const kFurthest = 1.5; // metres from the root, on a head of the bundled one's size; a plane seen from its edge reaches anywhere
const kNearest = 1e-4; // metres between two points: a second click in one place is none
const kTurn = Math.PI / 36; // of the plane, per key

/**
 * New strokes. Pressed on the head and drawn, a stroke is made in one go. Clicked there, it begins point by point, as in the paper:
 * the following clicks go on a plane through the root.
 */
export class DrawTool implements Tool {
  readonly plane = new DrawPlane();
  private freehand: Freehand | null = null;
  private root: Vector3 | null = null;
  /** Point by point: what was clicked so far, and where the next click would go. */
  private clicked: Vector3[] = [];
  private aim: Vector3 | null = null;

  constructor(private readonly studio: Studio, private readonly scene: Scene, private readonly words: () => typeof stageText.en) {
    scene.viewport.stage.scene.add(this.plane.group);
    studio.pen.changed(() => this.clicked.length > 0 && this.showClicked());
  }

  start(): void {
    this.studio.select([]);
  }

  stop(): void {
    this.finish();
  }

  press({ ray, pressure }: StagePointer): boolean {
    if (this.clicked.length > 0) return false;
    const hit = this.scene.head.value.hit(ray);
    if (!hit) return false;
    this.root = hit.point;
    const { viewport, head } = this.scene;
    const view = viewport.view;
    if (this.studio.pen.value.follows === "plane") this.plane.place(hit.point, view.clone().negate());
    const plane = this.studio.pen.value.follows === "plane" ? this.plane.plane : null;
    this.freehand = new Freehand({ hit: (one) => head.value.hit(one), plane, view, scale: this.scale }, hit.point, pressure);
    return true;
  }

  drag(trail: readonly StagePointer[]): void {
    if (!this.freehand) return;
    for (const { ray, pressure } of trail) this.freehand.follow(ray, pressure);
    this.studio.drawn.value = this.freehand.tuft(this.newTuft());
    this.scene.viewport.overlay.show([], [{ places: this.freehand.line, kind: "drawn" }]);
  }

  release(_pointer: StagePointer, isClick: boolean): void {
    const tuft = isClick ? null : (this.freehand?.tuft(this.newTuft()) ?? null);
    this.freehand = null;
    if (tuft) this.keep(tuft);
    else if (isClick && this.root) this.begin(this.root);
    else this.clear();
  }

  cancel(): void {
    this.clear();
  }

  click(pointer: StagePointer): void {
    if (this.clicked.length === 0) return;
    const place = this.placeOf(pointer);
    if (!place || place.distanceTo(this.clicked.at(-1)!) < kNearest * this.scale) return;
    this.clicked.push(place);
    this.showClicked();
  }

  doubleClick(): void {
    if (this.clicked.length > 1) this.finish();
  }

  hover(pointer: StagePointer | null): void {
    if (this.clicked.length > 0) {
      this.aim = pointer && this.placeOf(pointer);
      this.showClicked(false);
      return;
    }
    const hit = pointer && this.scene.head.value.hit(pointer.ray);
    this.scene.viewport.canvas.style.cursor = hit ? "crosshair" : "grab";
    this.scene.viewport.overlay.show(hit ? [{ place: hit.point, name: "", kind: "mark" }] : [], []);
  }

  key(event: KeyboardEvent): boolean {
    if (this.clicked.length === 0) return false;
    if (event.key === "Enter") this.finish();
    else if (event.key === "Escape") this.clear();
    else if (event.key === "Backspace" || event.key === "Delete") this.takeBack();
    else if (event.key === "f" || event.key === "F") this.faceEye();
    else if (event.shiftKey && event.key.startsWith("Arrow")) this.turnPlane(event.key);
    else return false;
    return true;
  }

  /** Whether a stroke is being made point by point. */
  get isClicking(): boolean {
    return this.clicked.length > 0;
  }

  private begin(root: Vector3): void {
    this.clicked = [root];
    this.plane.size = this.scale;
    this.plane.place(root, this.scene.viewport.view.negate());
    this.plane.group.visible = true;
    this.showClicked();
  }

  private takeBack(): void {
    this.clicked.pop();
    if (this.clicked.length === 0) this.clear();
    else this.showClicked();
  }

  private faceEye(): void {
    this.plane.place(this.plane.root, this.scene.viewport.view.negate());
    this.showClicked();
  }

  private turnPlane(key: string): void {
    const { camera } = this.scene.viewport;
    const axis = new Vector3().setFromMatrixColumn(camera.matrixWorld, key === "ArrowLeft" || key === "ArrowRight" ? 1 : 0);
    this.plane.turnBy(axis, key === "ArrowLeft" || key === "ArrowUp" ? -kTurn : kTurn);
    this.showClicked();
  }

  private placeOf({ ray }: StagePointer): Vector3 | null {
    const place = ray.intersectPlane(this.plane.plane, new Vector3());
    return place && place.distanceTo(this.plane.root) < kFurthest * this.scale ? place : null;
  }

  /** Kept, or given up if it has no second point. */
  finish(): void {
    if (this.clicked.length > 1) this.keep({ ...this.newTuft(), points: this.clicked.map(roundPoint) });
    else this.clear();
  }

  private get scale(): number {
    return headScale(this.scene.ball);
  }

  private newTuft(): Omit<Tuft, "points"> {
    return { name: "tuft", ...this.studio.pen.value.shape };
  }

  private keep(tuft: Tuft): void {
    const { document, pen } = this.studio;
    const kept = pen.value.mirrors ? [{ ...tuft, name: "tuft_L" }, mirrorTuft({ ...tuft, name: "tuft_L" }, document.head)] : [tuft];
    this.studio.edit((old) => addTufts(old, kept));
    this.clear();
  }

  private clear(): void {
    this.clicked = [];
    this.aim = null;
    this.root = null;
    this.freehand = null;
    this.plane.group.visible = false;
    this.studio.drawn.value = null;
    this.scene.viewport.overlay.show([], []);
    this.scene.viewport.invalidate();
  }

  private showClicked(changes = true): void {
    const places = this.aim ? [...this.clicked, this.aim] : this.clicked;
    const lines: Line[] = places.length > 1 ? [{ places: strokeLine(places.map(roundPoint)), kind: this.aim ? "aim" : "drawn" }] : [];
    const points: Handle[] = this.clicked.map((place, i) => ({ place, name: this.words().point(i + 1), kind: i === 0 ? "root" : "point" }));
    const handle: Handle = {
      place: this.plane.handle, name: this.words().planeHandle, kind: "plane",
      onDrag: (event) => {
        this.plane.turnTo(this.scene.viewport.rayAt(event.clientX, event.clientY));
        this.scene.viewport.invalidate();
        this.showClicked(false);
      },
      onKey: (event) => {
        if (!event.key.startsWith("Arrow")) return this.key(event);
        this.turnPlane(event.key);
        return true;
      },
    };
    const arm: Line = { places: [this.plane.root.clone(), this.plane.handle], kind: "aim" };
    this.scene.viewport.overlay.show([...points, handle], [...lines, arm]);
    if (changes) this.studio.drawn.value = this.clicked.length > 1 ? { ...this.newTuft(), points: this.clicked.map(roundPoint) } : null;
    if (changes) this.scene.viewport.invalidate();
  }
}
