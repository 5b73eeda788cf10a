// tufts.png: what the numbers of a tuft do.
import { loadHair } from "../hair.mjs";
import { kHair, kPaleInk, makeCanvas, writeText } from "../paint.mjs";
import { disposeScene, drawScene, makeCamera, makeScene } from "../stage.mjs";

const kTile = { width: 128, height: 220 };
const kRows = [
  [
    ["d25-p10", "diameter 25", "widest at 10 %", "rose"], ["d25-p80", "diameter 25", "widest at 80 %", "rose"],
    ["d100-p10", "diameter 100", "widest at 10 %", "rose"], ["d100-p80", "diameter 100", "widest at 80 %", "rose"],
    ["cap", "diameter 60", "widest at 100 %", "rose"], ["hairpin", "a hairpin", "tighter than thick", "teal"], ["ringlet", "a ringlet", "tighter than thick", "teal"],
  ],
  [
    ["sine", "taper", "sine", "violet"], ["linear", "taper", "linear", "violet"], ["smooth", "taper", "smooth", "violet"], ["round", "taper", "round", "violet"],
    ["flat", "ellipse", "flatness 0.75", "gold"], ["edge", "ellipse", "roll 90°", "gold"], ["twist", "ellipse", "twist 540°", "gold"],
  ],
];
const kLabel = 48;

async function drawTuft(context, name, paint, tile) {
  const scene = makeScene({ center: [0, 0.1, 0] });
  const hair = await loadHair(name, { ...paint, roundness: 0, band: [0.45, 0.1] });
  scene.add(hair.group);
  drawScene(context, scene, makeCamera({ at: [0, 0.105, 0], azimuth_deg: 20, elevation_deg: 8, height: 0.26 }), tile);
  disposeScene(scene);
}

export async function drawTufts() {
  const { canvas, context } = makeCanvas(kRows[0].length * kTile.width, kRows.length * (kTile.height + kLabel));
  for (const [row, samples] of kRows.entries()) {
    for (const [column, [name, first, second, color]] of samples.entries()) {
      const tile = { x: column * kTile.width, y: row * (kTile.height + kLabel), ...kTile };
      await drawTuft(context, name, kHair[color], tile);
      writeText(context, first, tile.x + tile.width / 2, tile.y + tile.height + 6, { size: 13 });
      writeText(context, second, tile.x + tile.width / 2, tile.y + tile.height + 24, { size: 12, color: kPaleInk });
    }
  }
  return { frames: [{ canvas, hold: 1 }], fps: 24 };
}
