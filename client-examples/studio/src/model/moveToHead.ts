import type { Head, Vec3 } from "../api/contract";
import type { StudioDocument } from "./StudioDocument";
import { cross, dot, normalize, subtract } from "./vector";

/** Unit axes of a head: its side, up, front. */
function axesOf({ up = [0, 1, 0], front = [0, 0, 1] }: Head): [Vec3, Vec3, Vec3] {
  const side = normalize(cross(up, front));
  const upward = normalize(up);
  return [side, upward, cross(side, upward)];
}

/** The hair of one head on another: about its center, turned to its front, and larger or smaller as the head is. */
export function moveToHead(document: StudioDocument, head: Head): StudioDocument {
  const old = document.head;
  const [from, to] = [axesOf(old), axesOf(head)];
  const factor = (head.diameter_at_100 ?? 0.1) / (old.diameter_at_100 ?? 0.1);
  const start: Vec3 = old.center ?? [0, 0, 0];
  const end: Vec3 = head.center ?? [0, 0, 0];
  const place = (point: Vec3): Vec3 => {
    const arm = subtract(point, start);
    const parts = from.map((axis) => factor * dot(arm, axis));
    const at = (k: 0 | 1 | 2) => Number((end[k] + parts.reduce((sum, part, i) => sum + part * to[i]![k], 0)).toFixed(6)) + 0;
    return [at(0), at(1), at(2)];
  };
  const gust = document.motion.phase?.gust_wavelength;
  const motion = gust == null ? document.motion : { ...document.motion, phase: { ...document.motion.phase, gust_wavelength: Number((gust * factor).toPrecision(4)) } };
  return { ...document, head, motion, tufts: document.tufts.map((tuft) => ({ ...tuft, points: tuft.points.map(place) })) };
}
