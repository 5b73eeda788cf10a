import { duplicateTufts } from "../model/duplicateTufts";
import type { StudioTuft } from "../model/StudioDocument";
import type { Studio } from "../Studio";

/** Makes one more of each selected tuft, which are selected then. @param make  a copy, or what the mirror shows */
export function copySelected(studio: Studio, make: (tuft: StudioTuft) => StudioTuft): void {
  if (studio.selection.value.length === 0) return;
  const { document, added } = duplicateTufts(studio.document, studio.selection.value, make);
  studio.edit(() => document);
  studio.select(added);
}
