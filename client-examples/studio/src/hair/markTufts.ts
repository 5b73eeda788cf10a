import type { BufferGeometry } from "three";
import type { TuftPart } from "./mergedTufts";

/**
 * Mixes the accent into some tufts of a merged geometry.
 * @param parts  that it was merged of
 * @param strength  0..1 for the number of a tuft
 */
export function markTufts(merged: BufferGeometry, parts: readonly TuftPart[], strength: (tuft: number) => number): void {
  const mark = merged.getAttribute("mark");
  let from = 0;
  parts.forEach(({ geometry }, i) => {
    const to = from + geometry.getAttribute("position").count;
    (mark.array as Float32Array).fill(strength(i), from, to);
    from = to;
  });
  mark.needsUpdate = true;
}
