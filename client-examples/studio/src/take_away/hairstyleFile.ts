import { toHairstyle } from "../model/toHairstyle";
import type { StudioDocument } from "../model/StudioDocument";

/** The document as JSON that the service takes and this page opens. A line for each point, so that people can read and compare it. */
export function hairstyleFile(document: StudioDocument): string {
  const spread = JSON.stringify(toHairstyle(document), null, 2);
  // Lists without quotes, braces or lists in them are numbers. Texts hold no line breaks, so none of them is touched.
  return `${spread.replace(/\[\n\s*([^"[\]{}]*?)\n\s*\]/g, (_, numbers: string) => `[${numbers.replace(/,\n\s*/g, ", ")}]`)}\n`;
}
