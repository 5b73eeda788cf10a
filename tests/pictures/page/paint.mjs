// The paint box.
import { hairTones } from "../../../client-examples/studio/src/paint/hairTones";

export const kPaper = "#fbf7f2";
export const kInk = "#4a4058";
export const kPaleInk = "#a99fb5";
export const kAccent = "#e8638c";

const hair = (color) => ({ ...hairTones(color), band: [0.62, 0.085], roundness: 0.45, pixels: 1.3 });

export const kHair = {
  rose: hair("#f58aac"),
  teal: hair("#5cc6cd"),
  gold: hair("#f9d57f"),
  violet: hair("#8f8ddb"),
  auburn: hair("#d17a52"),
};

/** A canvas filled with paper. */
export function makeCanvas(width, height) {
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { width, height });
  const context = canvas.getContext("2d");
  context.fillStyle = kPaper;
  context.fillRect(0, 0, width, height);
  return { canvas, context };
}

export function writeText(context, text, x, y, { size = 14, color = kInk, align = "center", weight = "normal" } = {}) {
  context.font = `${weight} ${size}px "DejaVu Sans", sans-serif`;
  context.fillStyle = color;
  context.textAlign = align;
  context.textBaseline = "middle";
  context.fillText(text, x, y);
}
