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
 * Writes each picture's number beside its tip, outside of the tip's path. That of the current one has its place; where
 * tips are near each other the others give way downwards by up to a line, and beyond that are left out.
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
    .sort((a, b) => Number(b.picture === current) - Number(a.picture === current) || a.y - b.y);
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.strokeStyle = look.paper;
  context.lineWidth = 3;
  const taken: Point[] = [];
  for (const { picture, x, y: wanted } of places) {
    let y = wanted;
    for (const [besideX, besideY] of taken) if (Math.abs(besideX - x) < kLine && Math.abs(besideY - y) < kLine) y = besideY + kLine;
    if (y > wanted + kLine) continue;
    taken.push([x, y]);
    taken.sort((a, b) => a[1] - b[1]);
    context.font = `${picture === current ? "bold " : ""}${look.font}`;
    context.fillStyle = picture === current ? look.ink : look.soft;
    context.strokeText(String(picture + 1), x, y);
    context.fillText(String(picture + 1), x, y);
  }
}
