/**
 * Runs in the page: reads the picture of the stage once it is drawn, without the handles over it.
 * @return  hash: of all pixels; changed: how many differ from those at the last look, all at the first
 */
export async function lookAtStage() {
  await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const canvas = document.querySelector(".stage-canvas");
  const { width, height } = canvas;
  const copy = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  const pixels = new Uint32Array(copy.getImageData(0, 0, width, height).data.buffer);
  const last = window.lastLook;
  window.lastLook = pixels;
  let hash = 0x811c9dc5;
  let changed = 0;
  for (let i = 0; i < pixels.length; i++) {
    hash = Math.imul(hash ^ pixels[i], 0x01000193) >>> 0;
    if (last?.[i] !== pixels[i]) changed += 1;
  }
  return { hash, changed };
}
