// Frames to one PNG file: a palette, and for several frames an animation with exact delays.
import { crc32 } from "./crc32.mjs";
import UPNG from "upng-js";

/** @return  width, height and RGBA of the picture, `samples` times smaller on each side: the mean of their squares */
function shrunk(png, samples) {
  const decoded = UPNG.decode(png);
  const pixels = new Uint8Array(UPNG.toRGBA8(decoded)[0]);
  const [width, height] = [decoded.width / samples, decoded.height / samples];
  const sums = new Float64Array(4 * width * height);
  for (let i = 0; i < pixels.length; i++) {
    const [x, y] = [(i >> 2) % decoded.width, Math.floor((i >> 2) / decoded.width)];
    sums[4 * (Math.floor(y / samples) * width + Math.floor(x / samples)) + (i & 3)] += pixels[i];
  }
  return { width, height, rgba: Uint8Array.from(sums, (sum) => Math.round(sum / samples ** 2)).buffer };
}

/** UPNG writes milliseconds; 2/24 s are none. Frame control chunks get the fraction itself. */
function writeDelays(file, holds, fps) {
  let frame = 0;
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
    if (file.toString("latin1", at + 4, at + 8) !== "fcTL") continue;
    file.writeUInt16BE(holds[frame++], at + 8 + 20);
    file.writeUInt16BE(fps, at + 8 + 22);
    file.writeUInt32BE(crc32(file.subarray(at + 4, at + 8 + 26)), at + 8 + 26);
  }
  if (frame !== holds.length) throw new Error(`${frame} frames were written, ${holds.length} are wanted`);
}

/** @param frames  png (a Buffer) and hold (frames of 1/fps s) each
 *  @param samples  a side that the frames have for each pixel of the file
 *  @param colors  size of the palette, at most 256 */
export function encode({ frames, fps, samples = 1 }, colors) {
  const pictures = frames.map(({ png }) => shrunk(png, samples));
  const [{ width, height }] = pictures;
  const delays = frames.map(({ hold }) => (1000 * hold) / fps);
  const file = Buffer.from(UPNG.encode(pictures.map(({ rgba }) => rgba), width, height, colors, delays));
  if (frames.length > 1) writeDelays(file, frames.map(({ hold }) => hold), fps);
  return { file, width, height };
}
