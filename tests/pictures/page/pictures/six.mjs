// six.png: six drawn tufts, and the head of hair that three fills make of them.
import { loadCharacter } from "../characters.mjs";
import { makeCanvas, writeText } from "../paint.mjs";
import { disposeScene, drawScene, makeCamera } from "../stage.mjs";

const kTile = { width: 300, height: 340 };
const kLabel = 36;
const kViews = [{ azimuth_deg: -28, elevation_deg: 6 }, { azimuth_deg: 205, elevation_deg: 10 }];

export async function drawSix() {
  const { canvas, context } = makeCanvas(3 * kTile.width, kTile.height + kLabel);
  const draw = (scene, view, column) => {
    const camera = makeCamera({ ...view, at: [0, -0.03, 0], height: 0.42 });
    drawScene(context, scene, camera, { x: column * kTile.width, y: 0, ...kTile });
  };
  const label = (text, column) => writeText(context, text, (column + 0.5) * kTile.width, kTile.height + 14, { size: 15, weight: "bold" });

  const drawn = await loadCharacter("bob", "drawn");
  draw(drawn.scene, kViews[0], 0);
  disposeScene(drawn.scene);
  const filled = await loadCharacter("bob", "none");
  for (const [i, view] of kViews.entries()) draw(filled.scene, view, i + 1);
  disposeScene(filled.scene);
  label(`${drawn.hair.tufts} tufts drawn`, 0);
  label(`${filled.hair.tufts} with three fills`, 1.5);
  return { frames: [{ canvas, hold: 1 }], fps: 24 };
}
