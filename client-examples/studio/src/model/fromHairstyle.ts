import type { Hairstyle } from "../api/contract";
import { newDocument } from "./newDocument";
import type { StudioDocument } from "./StudioDocument";
import { addTufts } from "./addTufts";

/** A hairstyle without fills as a document. What it leaves out is as in a new document; without a motion it gets that one. */
export function fromHairstyle(hairstyle: Hairstyle, name: string): StudioDocument {
  const fresh = newDocument();
  const document: StudioDocument = {
    name,
    head: hairstyle.head ?? fresh.head,
    color: hairstyle.mesh?.color ?? fresh.color,
    motion: hairstyle.motion ?? fresh.motion,
    tufts: [],
  };
  return addTufts(document, hairstyle.tufts);
}
