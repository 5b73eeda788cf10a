import type { Hairstyle } from "../api/contract";
import type { StudioDocument } from "./StudioDocument";

/** The document as the service takes it and as it is saved. */
export function toHairstyle({ head, tufts, motion, color }: StudioDocument): Hairstyle {
  return { head, tufts: tufts.map(({ id: _, ...tuft }) => tuft), motion, mesh: { color } };
}
