import type { Head, Tuft, Vec3 } from "../api/contract";
import { cross, dot, normalize, scale, subtract } from "./vector";

/** Across the face: the plane through the head's center that holds its up and its front. */
function mirrorPoint(point: Vec3, { center = [0, 0, 0], up = [0, 1, 0], front = [0, 0, 1] }: Head): Vec3 {
  const side = normalize(cross(up, front));
  return subtract(point, scale(side, 2 * dot(subtract(point, center), side)));
}

/** "side_L" to "side_R" and back; other names gain an "m". */
function mirrorName(name: string): string {
  const swapped = name.replace(/([_ .-])([LRlr])(?=\d*$|[_ .-]|$)/, (_, mark: string, side: string) => mark + ({ L: "R", R: "L", l: "r", r: "l" }[side] ?? side));
  return swapped === name ? `${name}_m` : swapped;
}

/** A tuft as the mirror shows it, its name of the other side. */
export function mirrorTuft<T extends Tuft>(tuft: T, head: Head): T {
  const turned = { ...(tuft.twist_deg ? { twist_deg: -tuft.twist_deg } : {}), ...(tuft.roll_deg ? { roll_deg: -tuft.roll_deg } : {}) };
  return { ...tuft, ...turned, name: mirrorName(tuft.name ?? ""), points: tuft.points.map((point) => mirrorPoint(point, head)) };
}
