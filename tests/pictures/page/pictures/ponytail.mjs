// ponytail.png: 1,648 strands, a thin tuft each, in calm air.
import { loadCharacter } from "../characters.mjs";
import { makeCanvas } from "../paint.mjs";
import { disposeScene, drawScene, makeCamera } from "../stage.mjs";

const kHeight = 440;
const kViews = [
  { azimuth_deg: -35, elevation_deg: 6, at: [0, -0.083, -0.03], width: 280 },
  { azimuth_deg: -114, elevation_deg: 5, at: [0, -0.083, -0.062], width: 380 },
  { azimuth_deg: 200, elevation_deg: 10, at: [0, -0.083, -0.03], width: 250 },
];

export async function drawPonytail() {
  const { scene } = await loadCharacter("ponytail", "calm");
  const { canvas, context } = makeCanvas(kViews.reduce((sum, { width }) => sum + width, 0), kHeight);
  let x = 0;
  for (const view of kViews) {
    drawScene(context, scene, makeCamera({ ...view, height: 0.408 }), { x, y: 0, width: view.width, height: kHeight });
    x += view.width;
  }
  disposeScene(scene);
  return { frames: [{ canvas, hold: 1 }], fps: 24 };
}
