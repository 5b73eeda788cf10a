// Frames to one PNG file: a palette, and for several frames an animation with exact delays.
import { crc32 } from "./crc32.mjs";
import UPNG from "upng-js";

const rgba = (png) => UPNG.toRGBA8(UPNG.decode(png))[0];

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
 *  @param colors  size of the palette, at most 256 */
export function encode(frames, fps, colors) {
  const { width, height } = UPNG.decode(frames[0].png);
  const delays = frames.map(({ hold }) => (1000 * hold) / fps);
  const file = Buffer.from(UPNG.encode(frames.map(({ png }) => rgba(png)), width, height, colors, delays));
  if (frames.length > 1) writeDelays(file, frames.map(({ hold }) => hold), fps);
  return { file, width, height };
}
