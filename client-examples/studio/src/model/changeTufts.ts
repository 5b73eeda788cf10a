import type { StudioDocument, StudioTuft } from "./StudioDocument";

/** The document with `change` made to the tufts whose ids are given. */
export function changeTufts(document: StudioDocument, ids: readonly number[], change: (tuft: StudioTuft) => StudioTuft): StudioDocument {
  return { ...document, tufts: document.tufts.map((tuft) => (ids.includes(tuft.id) ? { ...change(tuft), id: tuft.id } : tuft)) };
}
