import type { Schedule } from "../api/contract";
import { pictureOfFrame } from "../motion/pictureOfFrame";
import { pictureNames } from "./pictureNames";
import { readXdts } from "./readXdts";

/** What lies beside an XDTS: a file name for each picture, and a CSV that names them at each frame. */
export interface SheetFiles {
  readonly track: string;
  readonly pictures: readonly string[];
  readonly csv: string;
}

/**
 * Names pictures after the track of their sheet. The XDTS is the service's, so that there is one writer of it; the CSV is made here,
 * since the service's has no pictures to name: it is that one with a column more, `file`.
 * @param xdts  of the service, with one track
 * @throws Error if the sheet and the schedule are not of the same cycle, which no answer to the same hairstyle should be
 */
export function sheetFiles(xdts: string, schedule: Schedule): SheetFiles {
  const [track, ...others] = readXdts(xdts);
  const agrees = track && others.length === 0 && track.cells.length === schedule.pictures
    && track.cells.every(({ frame, cell }, i) => cell === String(i + 1) && frame === schedule.starts[i]);
  if (!agrees) throw new Error("the sheet does not agree with its pictures");
  const pictures = pictureNames(track.name, schedule.pictures);
  const rows = Array.from({ length: schedule.frames }, (_, frame) => {
    const picture = pictureOfFrame(schedule, frame);
    return [frame + 1, picture + 1, schedule.starts[picture] === frame ? 1 : 0, pictures[picture]].join(",");
  });
  return { track: track.name, pictures, csv: ["frame,picture,key,file", ...rows, ""].join("\r\n") };
}
