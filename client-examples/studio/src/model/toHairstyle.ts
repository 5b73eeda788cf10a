import type { Hairstyle } from "../api/contract";
import { bareTuft } from "./bareTuft";
import type { StudioDocument } from "./StudioDocument";

/** The document as the service takes it and as it is saved. */
export function toHairstyle({ head, tufts, motion, color }: StudioDocument): Hairstyle {
  return { head, tufts: tufts.map(bareTuft), motion, mesh: { color } };
}
