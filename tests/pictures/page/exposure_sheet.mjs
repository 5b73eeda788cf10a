// The exposure sheet of one cycle, laid on its side: a cell per frame, a number where the drawing changes, a line while it is held.
import { kAccent, kInk, kPaleInk, writeText } from "./paint.mjs";

/** Draws the sheet centered on x, its top at y, `picture` marked. */
export function drawExposureSheet(context, schedule, picture, { x, y, cell = 44, height = 34 }) {
  const left = x - (schedule.frames * cell) / 2;
  const start = schedule.starts[picture];
  context.fillStyle = "#ffffff";
  context.fillRect(left, y, schedule.frames * cell, height);
  context.fillStyle = kAccent;
  context.fillRect(left + start * cell, y, schedule.holds[picture] * cell, height);
  context.strokeStyle = kPaleInk;
  context.lineWidth = 1;
  for (let frame = 0; frame < schedule.frames; frame++) {
    context.strokeRect(left + frame * cell + 0.5, y + 0.5, cell, height);
    const now = frame >= start && frame < start + schedule.holds[picture];
    writeText(context, frame + 1, left + (frame + 0.5) * cell, y - 10, { size: 11, color: now ? kAccent : kPaleInk, weight: now ? "bold" : "normal" });
  }
  for (const [j, first] of schedule.starts.entries()) {
    const color = j === picture ? "#ffffff" : kInk;
    writeText(context, j + 1, left + (first + 0.5) * cell, y + height / 2 + 1, { size: 17, color, weight: "bold" });
    context.fillStyle = color;
    for (let frame = 1; frame < schedule.holds[j]; frame++) context.fillRect(left + (first + frame) * cell + 8, y + height / 2 - 0.5, cell - 16, 2);
  }
  writeText(context, "frame", left - 10, y - 10, { size: 11, color: kPaleInk, align: "right" });
  writeText(context, "picture", left - 10, y + height / 2 + 1, { size: 13, color: kInk, align: "right" });
  writeText(context, `${schedule.fps} fps`, left + schedule.frames * cell + 12, y + height / 2 + 1, { size: 13, color: kInk, align: "left" });
}
