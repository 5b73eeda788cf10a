import { PerspectiveCamera, Ray, Vector2, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { element } from "../base/element";
import { Stage } from "../paint/Stage";
import { Overlay } from "./Overlay";
import type { StagePointer } from "./StagePointer";
import type { Tool } from "./Tool";

const kClick_px = 5; // a press that moves less is a click
const kTurn = Math.PI / 24; // per arrow key
const kZoom = 1.1;
const kHeight = 0.46; // metres of the scene that a new picture shows
// Width of a picture to its height; a narrower one shows more at top and bottom, so that hair and the wind's arrow have room. Side by side
// there is no arrow.
const kNarrowest = 0.85;
const kNarrowestOfTwo = 0.62;
const kMiddle = new Vector3(0, -0.02, 0);
const kNearest = 0.65; // of that height, from the eye; and so on
const kFurthest = 17.4;
const kClip = [0.11, 44] as const;

/** Directions to look from, degrees right of the front and up. */
export const kViews = { front: [0, 0], quarter: [-32, 6], left: [90, 0], right: [-90, 0], back: [180, 5], top: [0, 80] } as const;
export type View = keyof typeof kViews;

/** The picture: a canvas with handles over it, an eye that is turned, and the tool of the mode. */
export class Viewport {
  readonly element: HTMLElement;
  readonly canvas = element("canvas", { className: "stage-canvas", tabIndex: 0 });
  readonly camera = new PerspectiveCamera(18, 1, 0.05, 20);
  readonly overlay = new Overlay();
  readonly stage: Stage;
  /** Called before each picture; @return whether another must follow at once. */
  onFrame: () => boolean = () => false;
  /** How many pictures stand side by side. */
  columns: () => number = () => 1;
  /** Draws; the whole canvas by default. */
  onDraw: () => void = () => this.stage.render(this.camera);
  private readonly controls: OrbitControls;
  private tool: Tool | null = null;
  private taken = false;
  private pressedAt: Vector2 | null = null;
  private moved = 0;
  private first: PointerEvent | null = null;
  private isHandingOver = false;
  private isStale = true;
  /** What is looked at: its middle, how much of the scene around it is shown, and how far it is turned to the left, radians. */
  private subject = { middle: kMiddle, height: kHeight, turn: 0 };

  /** @param name  what it is, for those who do not see it */
  constructor(name: string) {
    this.canvas.setAttribute("aria-label", name);
    this.canvas.setAttribute("role", "application");
    this.element = element("div", { className: "stage" }, this.canvas);
    this.element.append(this.overlay.element);
    this.stage = new Stage(this.canvas);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = false;
    this.controls.addEventListener("change", () => this.invalidate());
    this.look("quarter");
    this.listen();
    new ResizeObserver(() => this.resize()).observe(this.element);
    requestAnimationFrame(() => this.frame());
  }

  /** The picture is to be drawn anew. What lies over it needs no drawing. */
  invalidate(): void {
    this.isStale = true;
  }

  use(tool: Tool | null): void {
    this.tool?.stop?.();
    this.tool = tool;
    tool?.start?.();
    this.invalidate();
  }

  get view(): Vector3 {
    return this.camera.getWorldDirection(new Vector3());
  }

  get size(): { readonly width: number; readonly height: number } {
    return { width: this.element.clientWidth, height: this.element.clientHeight };
  }

  /**
   * Something else to look at.
   * @param height  of the scene that is shown, metres; null is as at the beginning
   * @param front  where its face looks
   */
  setSubject(middle: Vector3 | null, height: number | null, front: readonly [number, number, number], view: View = "quarter"): void {
    this.subject = { middle: middle ?? kMiddle, height: height ?? kHeight, turn: Math.atan2(front[0], front[2]) };
    this.controls.minDistance = kNearest * this.subject.height;
    this.controls.maxDistance = kFurthest * this.subject.height;
    [this.camera.near, this.camera.far] = [kClip[0] * this.subject.height, kClip[1] * this.subject.height];
    this.look(view);
  }

  look(view: View): void {
    const [azimuth, elevation] = kViews[view];
    const { middle, height, turn } = this.subject;
    const distance = height / 2 / Math.tan((this.camera.fov * Math.PI) / 360);
    this.controls.target.copy(middle);
    this.camera.position.setFromSphericalCoords(distance, ((90 - elevation) * Math.PI) / 180, (azimuth * Math.PI) / 180 + turn).add(middle);
    this.controls.update();
    this.invalidate();
  }

  /** From the eye through a place of the page. */
  rayAt(clientX: number, clientY: number): Ray {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    this.camera.updateMatrixWorld();
    const origin = new Vector3().setFromMatrixPosition(this.camera.matrixWorld);
    const through = new Vector3((2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height, 0.5).unproject(this.camera);
    return new Ray(origin, through.sub(origin).normalize());
  }

  private pointer(event: PointerEvent | MouseEvent): StagePointer {
    const { left, top } = this.canvas.getBoundingClientRect();
    const pressure = event instanceof PointerEvent && event.pointerType !== "mouse" && event.pressure > 0 ? event.pressure : 0.5;
    return { ray: this.rayAt(event.clientX, event.clientY), x: event.clientX - left, y: event.clientY - top, pressure, shift: event.shiftKey };
  }

  private listen(): void {
    // Before the controls hear of it, since they turn the view.
    this.element.addEventListener("pointerdown", (event) => this.press(event), { capture: true });
    this.canvas.addEventListener("pointermove", (event) => this.move(event));
    this.canvas.addEventListener("pointerup", (event) => this.release(event));
    this.canvas.addEventListener("pointercancel", (event) => this.release(event));
    this.canvas.addEventListener("pointerleave", () => !this.pressedAt && this.tool?.hover?.(null));
    this.canvas.addEventListener("dblclick", (event) => this.tool?.doubleClick?.(this.pointer(event)));
    this.canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    this.canvas.addEventListener("keydown", (event) => this.turnByKey(event));
    this.canvas.addEventListener("blur", () => this.canvas.classList.remove("is-pointed"));
  }

  private press(event: PointerEvent): void {
    if (event.target !== this.canvas || this.isHandingOver) return;
    if (!event.isPrimary) {
      this.handOver();
      return;
    }
    this.canvas.classList.add("is-pointed"); // only the keyboard needs to see the focus
    this.canvas.focus({ preventScroll: true });
    this.pressedAt = new Vector2(event.clientX, event.clientY);
    this.moved = 0;
    this.first = event;
    this.taken = event.button === 0 && (this.tool?.press?.(this.pointer(event)) ?? false);
    this.controls.enabled = !this.taken;
    if (this.taken) this.canvas.setPointerCapture(event.pointerId);
  }

  /** A second finger turns and zooms, together with the first: what that one began is given up, and the controls hear of it late. */
  private handOver(): void {
    const { first } = this;
    if (!this.taken || !first) return;
    this.tool?.cancel?.();
    this.taken = false;
    this.controls.enabled = true;
    this.isHandingOver = true;
    this.canvas.dispatchEvent(new PointerEvent("pointerdown", { pointerId: first.pointerId, pointerType: first.pointerType, clientX: first.clientX, clientY: first.clientY, isPrimary: true, button: 0, buttons: 1, bubbles: true }));
    this.isHandingOver = false;
    this.moved = Infinity; // no click comes of it
  }

  private move(event: PointerEvent): void {
    if (!this.pressedAt) {
      if (event.pointerType !== "touch") this.tool?.hover?.(this.pointer(event));
      return;
    }
    this.moved = Math.max(this.moved, this.pressedAt.distanceTo(new Vector2(event.clientX, event.clientY)));
    if (!this.taken || !event.isPrimary || this.moved < kClick_px) return;
    const events = event.getCoalescedEvents?.() ?? [];
    this.tool?.drag?.((events.length > 0 ? events : [event]).map((one) => this.pointer(one)));
  }

  private release(event: PointerEvent): void {
    if (!this.pressedAt) return;
    this.pressedAt = null;
    const isClick = this.moved < kClick_px;
    if (this.taken) this.tool?.release?.(this.pointer(event), isClick);
    else if (isClick && event.button === 0 && event.type === "pointerup") this.tool?.click?.(this.pointer(event));
    this.taken = false;
    this.controls.enabled = true;
  }

  private turnByKey(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (this.tool?.key?.(event)) event.preventDefault();
    else if (this.turn(event.key)) event.preventDefault();
  }

  private turn(key: string): boolean {
    const arm = this.camera.position.clone().sub(this.controls.target);
    const up = new Vector3(0, 1, 0);
    const side = new Vector3().crossVectors(up, arm).normalize();
    if (key === "ArrowLeft" || key === "ArrowRight") arm.applyAxisAngle(up, key === "ArrowLeft" ? -kTurn : kTurn);
    else if (key === "ArrowUp" || key === "ArrowDown") {
      const turned = arm.clone().applyAxisAngle(side, key === "ArrowUp" ? -kTurn : kTurn);
      if (Math.abs(turned.angleTo(up) - Math.PI / 2) > Math.PI / 2 - 0.05) return true;
      arm.copy(turned);
    } else if (key === "+" || key === "=") arm.divideScalar(kZoom);
    else if (key === "-") arm.multiplyScalar(kZoom);
    else return false;
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
    this.invalidate();
    return true;
  }

  private resize(): void {
    const { width, height } = this.size;
    if (width === 0 || height === 0) return;
    this.stage.resize(width, height, Math.min(2, devicePixelRatio));
    this.invalidate();
  }

  private frame(): void {
    requestAnimationFrame(() => this.frame());
    const draws = this.onFrame() || this.isStale;
    if (!draws && !this.overlay.isStale) return;
    this.isStale = false;
    const { width, height } = this.size;
    if (width === 0 || height === 0) return;
    this.camera.aspect = width / height;
    const columns = this.columns();
    this.camera.zoom = Math.min(1, width / columns / height / (columns > 1 ? kNarrowestOfTwo : kNarrowest));
    this.camera.updateProjectionMatrix();
    if (draws) this.onDraw();
    this.overlay.layout(this.camera, width, height);
  }
}
