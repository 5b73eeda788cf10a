// hero.png: one cycle of a head of hair in a breeze, as held pictures, over its exposure sheet.
import { loadCharacter } from "../characters.mjs";
import { drawExposureSheet } from "../exposure_sheet.mjs";
import { makeCanvas } from "../paint.mjs";
import { disposeStage, drawScene, makeCamera } from "../stage.mjs";

const kWidth = 720;
const kHeight = 456;
const kViews = [
  { azimuth_deg: -30, elevation_deg: 5, at: [-0.002, 0.081, 0], height: 0.39 },
  { azimuth_deg: 208, elevation_deg: 8, at: [0, 0.081, 0], height: 0.39 },
];
const kTile = { width: kWidth / 2, height: 384 };

export async function drawHero() {
  const { scene, hair } = await loadCharacter("vita", "breeze");
  const frames = hair.schedule.holds.map((hold, picture) => {
    const { canvas, context } = makeCanvas(kWidth, kHeight);
    hair.showPicture(picture);
    for (const [column, view] of kViews.entries()) drawScene(context, scene, makeCamera(view), { x: column * kTile.width, y: 0, ...kTile });
    drawExposureSheet(context, hair.schedule, picture, { x: kWidth / 2, y: 408 });
    return { canvas, hold };
  });
  disposeStage(scene);
  return { frames, fps: hair.schedule.fps };
}
