import { addTufts } from "./addTufts";
import type { StudioDocument, StudioTuft } from "./StudioDocument";

/** The document with `make` of each of the tufts at its end: a copy, or what the mirror shows. @return  also the new ids */
export function duplicateTufts(document: StudioDocument, ids: readonly number[], make: (tuft: StudioTuft) => StudioTuft = (tuft) => tuft): { document: StudioDocument; added: number[] } {
  const copies = ids.flatMap((id) => document.tufts.find((tuft) => tuft.id === id) ?? []).map(make);
  const changed = addTufts(document, copies);
  return { document: changed, added: changed.tufts.slice(document.tufts.length).map(({ id }) => id) };
}
