import { Vector3, type Camera } from "three";

/** A thing to take hold of, at a place of the scene. */
export interface Handle {
  readonly place: Vector3;
  readonly name: string;
  readonly kind: "point" | "root" | "plane" | "wind" | "mark";
  readonly isSelected?: boolean;
  onDrag?(event: PointerEvent): void;
  onSettle?(): void;
  onSelect?(): void;
  /** @return  whether it has a use for this key */
  onKey?(event: KeyboardEvent): boolean;
}

export interface Line {
  readonly places: readonly Vector3[];
  readonly kind: "stroke" | "drawn" | "aim" | "wind";
}

const kSvg = "http://www.w3.org/2000/svg";
const kRadius = { point: 6, root: 7, plane: 9, wind: 10, mark: 5 } as const; // pixels

/** Lines and handles over the picture, always as crisp and as large, which the keyboard reaches as well. */
export class Overlay {
  readonly element = document.createElementNS(kSvg, "svg");
  private handles: readonly Handle[] = [];
  private lines: readonly Line[] = [];
  private circles: SVGCircleElement[] = [];
  private paths: SVGPolylineElement[] = [];
  private held: Handle | null = null;
  private stale = true;

  constructor() {
    this.element.setAttribute("class", "overlay");
  }

  get isHeld(): boolean {
    return this.held !== null;
  }

  /** Whether something else is to be shown than what was put in its place last. */
  get isStale(): boolean {
    return this.stale;
  }

  /** What is shown from now on. Handles keep their element, and so the focus, by their number. */
  show(handles: readonly Handle[], lines: readonly Line[]): void {
    this.stale = true;
    this.handles = handles;
    this.lines = lines;
    while (this.paths.length < lines.length) this.paths.push(this.element.insertBefore(document.createElementNS(kSvg, "polyline"), this.circles[0] ?? null));
    while (this.paths.length > lines.length) this.paths.pop()!.remove();
    while (this.circles.length < handles.length) this.circles.push(this.element.appendChild(this.makeCircle(this.circles.length)));
    while (this.circles.length > handles.length) this.circles.pop()!.remove();
    lines.forEach(({ kind }, i) => this.paths[i]!.setAttribute("class", `line line-${kind}`));
    handles.forEach((handle, i) => this.dress(this.circles[i]!, handle));
  }

  /** Puts everything where it is seen now. */
  layout(camera: Camera, width: number, height: number): void {
    this.stale = false;
    const at = new Vector3();
    const seen = (place: Vector3) => {
      at.copy(place).project(camera);
      return [((at.x + 1) / 2) * width, ((1 - at.y) / 2) * height] as const;
    };
    this.lines.forEach(({ places }, i) => this.paths[i]!.setAttribute("points", places.map((place) => seen(place).map((x) => x.toFixed(1)).join(",")).join(" ")));
    this.handles.forEach(({ place }, i) => {
      const [x, y] = seen(place);
      this.circles[i]!.setAttribute("cx", x.toFixed(1));
      this.circles[i]!.setAttribute("cy", y.toFixed(1));
    });
  }

  private dress(circle: SVGCircleElement, { name, kind, isSelected, onDrag, onKey }: Handle): void {
    circle.setAttribute("class", `handle handle-${kind}${isSelected ? " is-selected" : ""}`);
    circle.setAttribute("r", String(kRadius[kind]));
    const isTaken = onDrag !== undefined || onKey !== undefined;
    circle.setAttribute("tabindex", isTaken ? "0" : "-1");
    circle.setAttribute("role", isTaken ? "button" : "presentation");
    circle.setAttribute("aria-label", name);
    circle.style.pointerEvents = isTaken ? "all" : "none";
  }

  private makeCircle(number: number): SVGCircleElement {
    const circle = document.createElementNS(kSvg, "circle");
    circle.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      const handle = this.handles[number];
      if (!handle?.onDrag) return;
      event.stopPropagation();
      circle.setPointerCapture(event.pointerId);
      circle.focus();
      this.held = handle;
      handle.onSelect?.();
    });
    circle.addEventListener("pointermove", (event) => this.held && this.handles[number]?.onDrag?.(event));
    const settle = () => {
      if (!this.held) return;
      this.held = null;
      this.handles[number]?.onSettle?.();
    };
    circle.addEventListener("pointerup", settle);
    circle.addEventListener("pointercancel", settle);
    circle.addEventListener("dblclick", (event) => event.stopPropagation());
    circle.addEventListener("focus", () => !this.held && this.handles[number]?.onSelect?.());
    circle.addEventListener("keydown", (event) => {
      if (!this.handles[number]?.onKey?.(event)) return;
      event.preventDefault();
      event.stopPropagation();
    });
    return circle;
  }
}
