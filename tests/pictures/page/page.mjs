// What painter.mjs calls: draws one picture and hands over its frames.
import { drawFills } from "./pictures/fills.mjs";
import { drawHeads } from "./pictures/heads.mjs";
import { drawPonytail } from "./pictures/ponytail.mjs";
import { drawSix } from "./pictures/six.mjs";
import { drawSteps } from "./pictures/steps.mjs";
import { drawTufts } from "./pictures/tufts.mjs";
import { drawUploads } from "./pictures/uploads.mjs";

const draw = { heads: drawHeads, ponytail: drawPonytail, tufts: drawTufts, steps: drawSteps, fills: drawFills, six: drawSix, uploads: drawUploads };

/** The frames of a picture as PNG data URLs, each with the exposure frames it is held for. */
window.drawPicture = async (name) => {
  const { frames, fps } = await draw[name]();
  return { fps, frames: frames.map(({ canvas, hold }) => ({ png: canvas.toDataURL("image/png"), hold })) };
};
