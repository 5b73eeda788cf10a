import { Vector3 } from "three";
import { headScale } from "../model/headScale";
import type { Studio } from "../Studio";
import type { stageText } from "../text/stageText";
import type { Scene } from "./Scene";
import type { Tool } from "./Tool";

const kArm = 0.2; // metres from the center to the handle, on a head of the bundled one's size
const kStart = 0.16; // outside of the head and of most hair
const kBarb = { from: 0.012, tip: 0.034, half: 0.014 }; // of the arrow, beyond its handle
const kTurn = Math.PI / 24; // per arrow key

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
    return new Vector3(...this.scene.ball.center);
  }

  private get wind(): Vector3 {
    return new Vector3(...(this.studio.document.motion.wind ?? [1, 0, 0])).normalize();
  }

  private get scale(): number {
    return headScale(this.scene.ball);
  }

  private show(): void {
    const { viewport } = this.scene;
    const { center, wind } = this;
    const at = (along: number) => center.clone().addScaledVector(wind, along * this.scale);
    const side = new Vector3().crossVectors(wind, viewport.view).normalize();
    const barb = (sign: number) => at(kArm + kBarb.from).addScaledVector(side, sign * kBarb.half * this.scale);
    viewport.overlay.show(
      [{
        place: at(kArm), name: this.words().windHandle, kind: "wind",
        onDrag: (event) => this.turnTo(event),
        onSettle: () => this.studio.history.settle(),
        onKey: (event) => this.turnBy(event.key),
      }],
      [
        { places: [at(kStart), at(kArm + kBarb.tip)], kind: "wind" },
        { places: [barb(1), at(kArm + kBarb.tip), barb(-1)], kind: "wind" },
      ],
    );
  }

  private turnTo({ clientX, clientY }: PointerEvent): void {
    const ray = this.scene.viewport.rayAt(clientX, clientY);
    const { center } = this;
    const nearest = ray.closestPointToPoint(center, new Vector3());
    const back = Math.sqrt(Math.max(0, (kArm * this.scale) ** 2 - nearest.distanceToSquared(center)));
    // The side of the ball on which it was, so that wind from the eye does not turn into wind towards it.
    const side = this.wind.dot(ray.direction) > 0 ? 1 : -1;
    this.set(nearest.addScaledVector(ray.direction, side * back).sub(center));
  }

  private turnBy(key: string): boolean {
    const { wind } = this;
    if (key === "ArrowLeft" || key === "ArrowRight") wind.applyAxisAngle(new Vector3(0, 1, 0), key === "ArrowLeft" ? -kTurn : kTurn);
    else if (key === "ArrowUp" || key === "ArrowDown") wind.applyAxisAngle(new Vector3().crossVectors(wind, new Vector3(0, 1, 0)).normalize(), key === "ArrowUp" ? kTurn : -kTurn);
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
