import type { Tuft } from "../api/contract";
import { nextId } from "./nextId";
import type { StudioDocument, StudioTuft } from "./StudioDocument";
import { uniqueName } from "./uniqueName";

/** The document with more tufts at its end, each with a name and an id of its own. */
export function addTufts(document: StudioDocument, tufts: readonly Tuft[]): StudioDocument {
  const names = new Set(document.tufts.map(({ name }) => name ?? ""));
  const first = nextId(document);
  const added = tufts.map((tuft, i): StudioTuft => {
    const name = uniqueName(tuft.name ?? "", names);
    names.add(name);
    return { ...tuft, name, id: first + i };
  });
  return { ...document, tufts: [...document.tufts, ...added] };
}
