import type { CyclePainter, PictureLook } from "./CyclePainter";

/**
 * Each picture of the cycle once, as PNG. Between two of them the page goes on.
 * @param onProgress  called before each picture, how many are done, and after the last
 * @throws DOMException AbortError if `signal` says so; Error if the browser has no memory for a picture of that size
 */
export async function renderPictures(
  painter: CyclePainter, pictures: number, look: PictureLook, signal: AbortSignal, onProgress: (done: number) => void,
): Promise<Uint8Array[]> {
  const pngs: Uint8Array[] = [];
  for (let picture = 0; picture < pictures; picture++) {
    onProgress(picture);
    await new Promise((resolve) => setTimeout(resolve));
    signal.throwIfAborted();
    pngs.push(await pngOf(painter.paint(picture, look)));
  }
  onProgress(pictures);
  return pngs;
}

async function pngOf(canvas: HTMLCanvasElement): Promise<Uint8Array> {
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
  if (!blob) throw new Error("the browser could not make a picture of that size");
  return new Uint8Array(await blob.arrayBuffer());
}
