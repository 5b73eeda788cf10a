import type { PlotLook } from "./PlotLook";

type Point = readonly [number, number];

/** Above this many, numbers would be a heap. */
const kMostNumbers = 12;
/** Pixels from the tip, and between numbers one above the other. */
const kDistance = 11;
const kLine = 12;

/** The middle between the two strands of the tip's path at a height. */
function middleOf(path: readonly Point[], height: number): number {
  const near = path.filter(([, y]) => Math.abs(y - height) < kLine / 2).map(([x]) => x);
  return (Math.min(...near) + Math.max(...near)) / 2;
}

/**
 * Writes each picture's number beside its tip, outside of the tip's path; where tips are near each other, numbers give way downwards.
 * @param tips  of each picture, pixels; so is path
 * @param current  the picture whose number stands out, from 0
 */
export function drawTipNumbers(
  context: CanvasRenderingContext2D,
  tips: readonly Point[],
  path: readonly Point[],
  current: number,
  look: PlotLook,
): void {
  if (tips.length > kMostNumbers) return;
  const places = tips
    .map(([x, y], picture) => ({ picture, x: x + (x < middleOf(path, y) ? -kDistance : kDistance), y }))
    .sort((a, b) => a.y - b.y);
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.strokeStyle = look.paper;
  context.lineWidth = 3;
  places.forEach((place, n) => {
    for (const above of places.slice(0, n)) if (Math.abs(above.x - place.x) < kLine) place.y = Math.max(place.y, above.y + kLine);
    const now = place.picture === current;
    const number = String(place.picture + 1);
    context.font = `${now ? "bold " : ""}${look.font}`;
    context.fillStyle = now ? look.ink : look.soft;
    context.strokeText(number, place.x, place.y);
    context.fillText(number, place.x, place.y);
  });
}
