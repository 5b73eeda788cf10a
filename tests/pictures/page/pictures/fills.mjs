// fills.png: figures 10 and 11 of the paper in our hands: two tufts, and what is filled between them step by step.
import { loadCharacter } from "../characters.mjs";
import { kInk, kPaleInk, makeCanvas, writeText } from "../paint.mjs";
import { disposeScene, drawScene, makeCamera } from "../stage.mjs";

const kTile = { width: 190, height: 210 };
const kLabel = 48;
const kViews = [{ azimuth_deg: -35, elevation_deg: 8 }, { azimuth_deg: 150, elevation_deg: 12 }];
const kSteps = [["two", "two tufts", "drawn"], ["along", "+ along", ""], ["crown", "+ crown", ""], ["neck", "+ neck", ""], ["jitter", "+ jitter", ""]];

export async function drawFills() {
  const { canvas, context } = makeCanvas(kSteps.length * kTile.width, kViews.length * kTile.height + kLabel);
  for (const [column, [step, first]] of kSteps.entries()) {
    const { scene, hair } = await loadCharacter("spiky", step);
    for (const [row, view] of kViews.entries()) {
      const camera = makeCamera({ ...view, at: [0, -0.01, 0], height: 0.42 });
      drawScene(context, scene, camera, { x: column * kTile.width, y: row * kTile.height, ...kTile });
    }
    const x = (column + 0.5) * kTile.width, y = kViews.length * kTile.height;
    writeText(context, first, x, y + 10, { size: 14, color: kInk });
    writeText(context, `${hair.tufts} tufts`, x, y + 30, { size: 12, color: kPaleInk });
    disposeScene(scene);
  }
  return { frames: [{ canvas, hold: 1 }], fps: 24 };
}
