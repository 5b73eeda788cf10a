import type { Head, Tuft } from "../api/contract";

/** What a tuft's mesh depends on, as text: equal keys have equal meshes. */
export function tuftKey(tuft: Tuft, { center, up, front, root_depth, diameter_at_100 }: Head): string {
  const { points, diameter, widest_at, taper, section, flatness, twist_deg, roll_deg, joints } = tuft;
  return JSON.stringify([points, diameter, widest_at, taper, section, flatness, twist_deg, roll_deg, joints, center, up, front, root_depth, diameter_at_100]);
}
