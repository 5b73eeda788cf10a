// The paint box. Tones are darkest first.
export const kPaper = "#fbf7f2";
export const kInk = "#4a4058";
export const kPaleInk = "#a99fb5";
export const kAccent = "#e8638c";

const hair = (tones, shine, line) => ({ tones, shine, line, band: [0.62, 0.085], roundness: 0.45, pixels: 1.3 });

export const kHair = {
  rose: hair(["#a8406f", "#d9608e", "#f58aac"], "#ffd3de", "#5c1f45"),
  teal: hair(["#1f6c8c", "#3199b0", "#5cc6cd"], "#d6f6f0", "#123f5c"),
  gold: hair(["#c4823e", "#e6ae55", "#f9d57f"], "#fff6d2", "#6e4120"),
  violet: hair(["#45408f", "#6560b8", "#8f8ddb"], "#dcdcfb", "#26225c"),
  auburn: hair(["#7e3328", "#ac4f38", "#d17a52"], "#f7c79c", "#431a1c"),
};

export const kSkin = { tones: ["#e9b3a2", "#f6cfbf", "#fee9dc"], line: "#8a5348", pixels: 1.3 };

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
