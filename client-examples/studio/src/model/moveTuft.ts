import type { StudioDocument } from "./StudioDocument";

/** The document with a tuft at another place of the list; places beyond an end are that end. */
export function moveTuft(document: StudioDocument, id: number, place: number): StudioDocument {
  const tuft = document.tufts.find((one) => one.id === id);
  if (!tuft) return document;
  const others = document.tufts.filter((one) => one !== tuft);
  const to = Math.max(0, Math.min(others.length, place));
  return { ...document, tufts: [...others.slice(0, to), tuft, ...others.slice(to)] };
}
