import { drawTipNumbers } from "./drawTipNumbers";
import type { PlotLook } from "./PlotLook";
import type { WaveShape } from "./WaveShape";

type Point = readonly [number, number];

/** Pixels around the plot; the bottom has room for the words, the right for the pictures' numbers. */
const kMargin = { left: 20, right: 30, top: 18, bottom: 30 };
/** How strongly the first and the last picture are drawn. */
const kTones: readonly [number, number] = [0.14, 0.62];

function strokeLine(context: CanvasRenderingContext2D, points: readonly Point[]): void {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
  context.stroke();
}

function dot(context: CanvasRenderingContext2D, [x, y]: Point, radius: number): void {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}

/** The straight line from root to tip and its two ends, named. */
function drawAxis(context: CanvasRenderingContext2D, look: PlotLook, root: Point, tip: Point, height: number): void {
  context.strokeStyle = context.fillStyle = look.soft;
  context.lineWidth = 1;
  context.globalAlpha = 0.45;
  // On whole pixels and a half a line of one pixel is crisp.
  const crisp = (value: number) => Math.round(value) + 0.5;
  strokeLine(context, [[root[0], crisp(root[1])], [tip[0], crisp(tip[1])]]);
  context.setLineDash([2, 4]);
  for (const [x] of [root, tip]) strokeLine(context, [[crisp(x), kMargin.top / 2], [crisp(x), height - kMargin.bottom + 8]]);
  context.setLineDash([]);
  context.globalAlpha = 1;
  context.textBaseline = "alphabetic";
  context.textAlign = "center";
  context.fillText(look.root, Math.max(root[0], kMargin.left), height - 8);
  context.fillText(look.tip, tip[0], height - 8);
}

/**
 * Draws the plot of a wave: the hair of all pictures from pale to dark, the tip's path, and strongest the wave and the hair of one picture.
 * The scale is the same in x and y, so hair looks as it is, and it is that of the whole cycle, so nothing jumps in playback.
 * @param picture  from 0
 */
export function drawWave(
  context: CanvasRenderingContext2D,
  [width, height]: Point,
  shape: WaveShape,
  picture: number,
  look: PlotLook,
): void {
  const [bottom, top] = [Math.min(shape.bottom, -0.25), Math.max(shape.top, 0.25)];
  const inner: Point = [width - kMargin.left - kMargin.right, height - kMargin.top - kMargin.bottom];
  const scale = Math.max(Math.min(inner[0] / Math.PI, inner[1] / (top - bottom)), 1);
  const left = kMargin.left + (inner[0] - scale * Math.PI) / 2;
  const middle = kMargin.top + inner[1] / 2 + (scale * (top + bottom)) / 2;
  const place = ([x, y]: Point): Point => [left + scale * x, middle - scale * y];
  const hairs = shape.hairs.map((hair) => hair.map(place));

  context.clearRect(0, 0, width, height);
  context.lineJoin = context.lineCap = "round";
  context.font = look.font;
  drawAxis(context, look, place([0, 0]), place([Math.PI, 0]), height);

  context.strokeStyle = look.ink;
  context.lineWidth = 1.5;
  hairs.forEach((hair, n) => {
    context.globalAlpha = kTones[0] + ((kTones[1] - kTones[0]) * n) / Math.max(hairs.length - 1, 1);
    strokeLine(context, hair);
  });

  const [tips, path] = [hairs.map((hair) => hair[hair.length - 1] ?? place([0, 0])), shape.tipPath.map(place)];
  context.globalAlpha = 1;
  context.strokeStyle = context.fillStyle = look.soft;
  context.lineWidth = 1;
  strokeLine(context, path);
  for (const tip of tips) dot(context, tip, 2.25);

  // The hair of this picture, then the wave over it. A steep wave leaves the plot; it ends at its edge.
  const hair = hairs[picture] ?? [];
  context.strokeStyle = context.fillStyle = look.ink;
  context.lineWidth = 2;
  strokeLine(context, hair);
  context.save();
  context.beginPath();
  context.rect(0, 2, width, height - kMargin.bottom + 4);
  context.clip();
  context.strokeStyle = look.accent;
  context.lineWidth = 3;
  strokeLine(context, (shape.curves[picture] ?? []).map(place));
  context.restore();
  drawTipNumbers(context, tips, path, picture, look);
  context.fillStyle = look.ink;
  dot(context, place([0, 0]), 3);
  dot(context, tips[picture] ?? place([Math.PI, 0]), 4);
}
