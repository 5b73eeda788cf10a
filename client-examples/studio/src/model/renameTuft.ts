import { changeTufts } from "./changeTufts";
import type { StudioDocument } from "./StudioDocument";
import { uniqueName } from "./uniqueName";

/** The document with another name for a tuft; if another has it, a number comes behind it. */
export function renameTuft(document: StudioDocument, id: number, name: string): StudioDocument {
  const others = document.tufts.filter((tuft) => tuft.id !== id).map((tuft) => tuft.name ?? "");
  return changeTufts(document, [id], (tuft) => ({ ...tuft, name: uniqueName(name, others) }));
}
