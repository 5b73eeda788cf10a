// steps.png: the strokes, the tufts that they become, and the cycle's pictures on top of each other.
import { setTones } from "../../../../client-examples/studio/src/paint/setTones";
import { kSkin } from "../../../../client-examples/studio/src/paint/skinPaint";
import { loadCharacter } from "../characters.mjs";
import { kAccent, kInk, kPaleInk, makeCanvas, writeText } from "../paint.mjs";
import { disposeScene, drawScene, makeCamera } from "../stage.mjs";
import { makeStrokes } from "../strokes.mjs";

const kTile = { width: 300, height: 350 };
const kArrow = 30;
const kLabel = 40;
const kTop = 2; // the picture in which this hair hangs lowest
const kGhosts = [["#fbdfe7", "#e8638c"], ["#fde6d3", "#ef8f4a"], [], ["#dcf1e4", "#3fae7c"], ["#d9eaf7", "#4a92cf"], ["#e9e0f5", "#9069c4"]]; // fill, line

function drawArrow(context, x, y) {
  context.strokeStyle = kPaleInk;
  context.lineWidth = 3;
  context.lineCap = context.lineJoin = "round";
  context.beginPath();
  context.moveTo(x - 12, y);
  context.lineTo(x + 12, y);
  context.moveTo(x + 4, y - 8);
  context.lineTo(x + 12, y);
  context.lineTo(x + 4, y + 8);
  context.stroke();
}

/** The other pictures of the cycle, hair only, as through paper on a light table. */
function drawOtherPictures(context, scene, { hair, head }, camera, tile) {
  head.group.visible = false;
  for (let picture = hair.schedule.pictures - 1; picture >= 0; picture--) {
    if (picture === kTop) continue;
    const [fill, line] = kGhosts[picture];
    setTones(hair.material, [fill, fill, fill]);
    hair.material.uniforms.band.value.y = 0;
    hair.line.uniforms.line.value.set(line);
    hair.showPicture(picture);
    drawScene(context, scene, camera, tile);
  }
  head.group.visible = true;
}

function drawTopPicture(context, scene, { hair, paint }, camera, tile) {
  setTones(hair.material, paint.tones);
  hair.material.uniforms.band.value.set(...paint.band);
  hair.line.uniforms.line.value.set(paint.line);
  hair.showPicture(kTop);
  drawScene(context, scene, camera, tile);
}

export async function drawSteps() {
  const camera = makeCamera({ at: [0.002, 0.082, 0], azimuth_deg: -30, elevation_deg: 5, height: 0.41 });
  const { canvas, context } = makeCanvas(3 * kTile.width + 2 * kArrow, kTile.height + kLabel);
  const tile = (column) => ({ x: column * (kTile.width + kArrow), y: 0, ...kTile });

  const still = await loadCharacter("vita", "none");
  drawScene(context, still.scene, camera, tile(1));
  still.hair.group.visible = false;
  still.head.setScalpTones(kSkin.tones, still.paint.tones[0]);
  still.scene.add(makeStrokes(still.request.tufts, { line: kInk, point: "#4aa8c4", root: kAccent }));
  drawScene(context, still.scene, camera, tile(0));
  disposeScene(still.scene);

  const moving = await loadCharacter("vita", "breeze");
  drawOtherPictures(context, moving.scene, moving, camera, tile(2));
  drawTopPicture(context, moving.scene, moving, camera, tile(2));
  disposeScene(moving.scene);

  for (const column of [0, 1]) drawArrow(context, (column + 1) * kTile.width + (column + 0.5) * kArrow, kTile.height / 2);
  const labels = [`${still.request.tufts.length} strokes`, `${still.request.tufts.length} tufts`, `${moving.hair.schedule.pictures} pictures`];
  for (const [column, label] of labels.entries()) writeText(context, label, tile(column).x + kTile.width / 2, kTile.height + 16, { size: 16, weight: "bold" });
  return { frames: [{ canvas, hold: 1 }], fps: 24 };
}
