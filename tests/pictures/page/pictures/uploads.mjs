// uploads.png: two characters that others made, posted as they are, in a breeze.
import { drawExposureSheet } from "../exposure_sheet.mjs";
import { makeCanvas } from "../paint.mjs";
import { disposeScene, drawScene, makeCamera, makeScene } from "../stage.mjs";
import { loadUploaded } from "../uploaded.mjs";

const kTile = { width: 240, height: 360 };
const kSheet = 72;
const kTiles = [
  { name: "godette", azimuth_deg: 25, elevation_deg: 3, at: [0, 1.17, 0], height: 1.16 },
  { name: "godette", azimuth_deg: 150, elevation_deg: 3, at: [0, 1.17, 0], height: 1.16 },
  { name: "pmca", azimuth_deg: -118, elevation_deg: 4, at: [0, 1.22, -0.03], height: 0.9 },
];

export async function drawUploads() {
  const tiles = [];
  for (const tile of kTiles) {
    const scene = makeScene({ center: tile.at });
    const uploaded = await loadUploaded(tile.name);
    scene.add(uploaded.group);
    tiles.push({ ...tile, scene, uploaded });
  }
  const { schedule } = tiles[0].uploaded;
  const frames = schedule.holds.map((hold, picture) => {
    const { canvas, context } = makeCanvas(tiles.length * kTile.width, kTile.height + kSheet);
    for (const [column, { scene, uploaded, ...view }] of tiles.entries()) {
      uploaded.showPicture(picture);
      drawScene(context, scene, makeCamera(view), { x: column * kTile.width, y: 0, ...kTile });
    }
    drawExposureSheet(context, schedule, picture, { x: canvas.width / 2, y: kTile.height + 24 });
    return { canvas, hold };
  });
  for (const { scene } of tiles) disposeScene(scene);
  return { frames, fps: schedule.fps };
}
