import { Plane, Vector3, type Ray } from "three";
import type { Tuft, Vec3 } from "../api/contract";
import type { Hit } from "../stage/HeadSurface";
import { roundPoint } from "./roundPoint";
import { simplifyStroke } from "./simplifyStroke";
import { strokeWidth } from "./strokeWidth";

// Metres, on a head of the bundled one's size.
const kClearance = 0.012; // of the line from the scalp: hair lies on hair
const kRise = 0.03; // from the root, over which the line rises to it
const kJump = 0.04; // a deeper step is behind a chin or an ear: the line goes on as it was
const kTolerance = 0.0025; // of simplification, less than a tuft's own width
const kFurthest = 1.5; // from the root
const kStep = 1e-4; // a pointer that trembles draws nothing

/** Where freehand points go: along the head while it is under the pointer, else on a plane. */
export interface Canvas {
  hit(ray: Ray): Hit | null;
  /** Points only on this plane; null follows the head, and beside it a plane that faces the eye. */
  readonly plane: Plane | null;
  /** From the eye into the picture. */
  readonly view: Vector3;
  /** Of the head; see headScale. */
  readonly scale: number;
}

/** A stroke that is being drawn in one go. */
export class Freehand {
  private readonly places: Vector3[];
  private readonly pressures: number[];
  private way = 0;

  constructor(private readonly canvas: Canvas, root: Vector3, pressure: number) {
    this.places = [root.clone()];
    this.pressures = [pressure];
  }

  /** The pointer went on. */
  follow(ray: Ray, pressure: number): void {
    const last = this.places.at(-1)!;
    const place = this.placeOf(ray, last);
    if (!place || place.distanceTo(this.places[0]!) > kFurthest * this.canvas.scale) return;
    const step = place.distanceTo(last);
    if (step < kStep * this.canvas.scale) return;
    this.way += step;
    this.places.push(place);
    this.pressures.push(pressure);
  }

  /** The line so far. */
  get line(): readonly Vector3[] {
    return this.places;
  }

  /** The tuft so far; null while there is no line. */
  tuft(shape: Omit<Tuft, "points">): Tuft | null {
    if (this.places.length < 2 || this.way < 4 * kTolerance * this.canvas.scale) return null;
    const steadied = this.places.map((place, i, all) => (i === 0 || i === all.length - 1 ? place : place.clone().multiplyScalar(2).add(all[i - 1]!).add(all[i + 1]!).divideScalar(4)));
    const line: Vec3[] = steadied.map(roundPoint);
    const kept = simplifyStroke(line, kTolerance * this.canvas.scale);
    const chosen = { diameter: shape.diameter ?? 40, widest_at: shape.widest_at ?? 40 };
    return { ...shape, ...strokeWidth(line, this.pressures, chosen), points: kept.map((i) => line[i]!) };
  }

  private placeOf(ray: Ray, last: Vector3): Vector3 | null {
    const { plane, view, scale } = this.canvas;
    if (plane) return ray.intersectPlane(plane, new Vector3());
    const hit = this.canvas.hit(ray);
    if (hit) {
      const clearance = kClearance * scale * Math.min(1, (this.way + hit.point.distanceTo(last)) / (kRise * scale));
      // Halfway between the normal and the eye: hair keeps its volume at the edge of the head, and yet stays near the pointer.
      const place = hit.point.clone().addScaledVector(hit.normal.clone().sub(ray.direction).normalize(), clearance);
      if (Math.abs(place.clone().sub(last).dot(view)) < kJump * scale) return place;
    }
    return ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(view, last), new Vector3());
  }
}
