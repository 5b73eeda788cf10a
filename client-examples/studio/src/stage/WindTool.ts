import { Vector3 } from "three";
import type { Vec3 } from "../api/contract";
import type { Studio } from "../Studio";
import type { stageText } from "../text/stageText";
import type { Scene } from "./Scene";
import type { Tool } from "./Tool";

const kArm = 0.17; // metres from the head's center to the arrow's end
const kStart = 0.135;
const kTurn = Math.PI / 24; // per arrow key
const kAxes: Vec3 = [0, 1, 0];

/** The wind: an arrow whose end is dragged around the head. */
export class WindTool implements Tool {
  private end: (() => void) | null = null;

  constructor(private readonly studio: Studio, private readonly scene: Scene, private readonly words: () => typeof stageText.en) {}

  start(): void {
    this.end = this.studio.history.current.changed(() => this.show());
    this.show();
  }

  stop(): void {
    this.end?.();
    this.scene.viewport.overlay.show([], []);
  }

  private get center(): Vector3 {
    return new Vector3(...(this.studio.document.head.center ?? [0, 0, 0]));
  }

  private get wind(): Vector3 {
    return new Vector3(...(this.studio.document.motion.wind ?? [1, 0, 0])).normalize();
  }

  private show(): void {
    const { viewport } = this.scene;
    const { center, wind } = this;
    const tip = center.clone().addScaledVector(wind, kArm);
    const side = new Vector3().crossVectors(wind, viewport.view).normalize();
    const barb = (sign: number) => tip.clone().addScaledVector(wind, -0.022).addScaledVector(side, sign * 0.014);
    const tail = center.clone().addScaledVector(wind, -kArm);
    viewport.overlay.show(
      [{
        place: tip, name: this.words().windHandle, kind: "wind",
        onDrag: (event) => this.turnTo(event),
        onSettle: () => this.studio.history.settle(),
        onKey: (event) => this.turnBy(event.key),
      }],
      [{ places: [center.clone().addScaledVector(wind, kStart), tip], kind: "wind" }, { places: [barb(1), tip, barb(-1)], kind: "wind" }, { places: [tail, center.clone().addScaledVector(wind, -kStart)], kind: "wind" }],
    );
    viewport.invalidate();
  }

  private turnTo({ clientX, clientY }: PointerEvent): void {
    const ray = this.scene.viewport.rayAt(clientX, clientY);
    const { center } = this;
    const nearest = ray.closestPointToPoint(center, new Vector3());
    const back = Math.sqrt(Math.max(0, kArm * kArm - nearest.distanceToSquared(center)));
    // The side of the ball on which it was, so that wind from the eye does not turn into wind towards it.
    const side = this.wind.dot(ray.direction) > 0 ? 1 : -1;
    this.set(nearest.addScaledVector(ray.direction, side * back).sub(center));
  }

  private turnBy(key: string): boolean {
    const { wind } = this;
    if (key === "ArrowLeft" || key === "ArrowRight") wind.applyAxisAngle(new Vector3(...kAxes), key === "ArrowLeft" ? -kTurn : kTurn);
    else if (key === "ArrowUp" || key === "ArrowDown") wind.applyAxisAngle(new Vector3().crossVectors(wind, new Vector3(...kAxes)).normalize(), key === "ArrowUp" ? kTurn : -kTurn);
    else return false;
    this.set(wind);
    return true;
  }

  /** Kept off the vertical, to which a wave that swings up and down could not be laid. */
  private set(direction: Vector3): void {
    const { x, y, z } = direction.normalize();
    if (Math.abs(y) > 0.985) return;
    const round = (value: number) => Math.round(value * 1000) / 1000 + 0;
    this.studio.edit((document) => ({ ...document, motion: { ...document.motion, wind: [round(x), round(y), round(z)] } }), "wind");
  }
}
