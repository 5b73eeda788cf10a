import type { StudioDocument } from "./StudioDocument";

/** An id that no tuft of the document has. */
export function nextId({ tufts }: StudioDocument): number {
  return tufts.reduce((id, tuft) => Math.max(id, tuft.id + 1), 1);
}
