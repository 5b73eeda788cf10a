import type { Schedule } from "../api/contract";
import { toHairstyle } from "../model/toHairstyle";
import type { Studio } from "../Studio";
import type { takeAwayText } from "../text/takeAwayText";
import type { CyclePainter, PictureLook } from "./CyclePainter";
import { fileName } from "./fileName";
import { renderPictures } from "./renderPictures";
import { sheetFiles } from "./sheetFiles";
import { zipPictures } from "./zipPictures";

/** A cycle that is to be painted: of the document as it is. */
export interface Cycle {
  readonly schedule: Schedule;
  readonly painter: CyclePainter;
}

/** The zip with every picture of the cycle, its sheet and how to load it. @throws as Service and renderPictures do */
export async function takePictures(
  studio: Studio, { schedule, painter }: Cycle, look: PictureLook, words: typeof takeAwayText.en, signal: AbortSignal, onProgress: (done: number) => void,
): Promise<Uint8Array<ArrayBuffer>> {
  const xdts = await studio.service.text("/v1/hairstyles", { body: toHairstyle(studio.document), query: { format: "xdts" }, signal });
  const { track, pictures, csv } = sheetFiles(xdts, schedule);
  const pngs = await renderPictures(painter, pictures.length, look, signal, onProgress);
  const name = fileName(studio.document.name);
  const { frames, fps } = schedule;
  const [first, last] = [pictures[0]!, pictures.at(-1)!];
  const { width, height } = look;
  const readme = words.readme({ name, track, first, last, pictures: pictures.length, frames, fps: String(fps), width, height });
  return zipPictures({
    name, xdts, csv,
    pictures: pictures.map((file, i) => ({ name: file, png: pngs[i]! })),
    readme: [...readme, ""].join("\r\n"), // for the plainest editors too
  });
}
