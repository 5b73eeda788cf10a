// heads.png: three heads of VRoid hair, from the front and from the back.
import { loadCharacter } from "../characters.mjs";
import { makeCanvas } from "../paint.mjs";
import { disposeScene, drawScene, makeCamera } from "../stage.mjs";

const kTile = { width: 300, height: 340 };
const kViews = [{ azimuth_deg: -30, elevation_deg: 5 }, { azimuth_deg: 205, elevation_deg: 10 }];

export async function drawHeads() {
  const { canvas, context } = makeCanvas(3 * kTile.width, kViews.length * kTile.height);
  for (const [column, name] of ["vita", "shibu", "fumiriya"].entries()) {
    const { scene } = await loadCharacter(name, "none");
    for (const [row, view] of kViews.entries()) {
      const camera = makeCamera({ ...view, at: [0, 0.095, 0], height: 0.437 });
      drawScene(context, scene, camera, { x: column * kTile.width, y: row * kTile.height, ...kTile });
    }
    disposeScene(scene);
  }
  return { frames: [{ canvas, hold: 1 }], fps: 24 };
}
