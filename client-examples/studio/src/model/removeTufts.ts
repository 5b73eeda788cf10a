import type { StudioDocument } from "./StudioDocument";

/** The document without the tufts whose ids are given. */
export function removeTufts(document: StudioDocument, ids: readonly number[]): StudioDocument {
  return { ...document, tufts: document.tufts.filter(({ id }) => !ids.includes(id)) };
}
