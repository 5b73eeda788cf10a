import type { Schedule } from "../api/contract";
import { pictureOfFrame } from "./pictureOfFrame";
import { wrap } from "./wrap";

/**
 * The first frame of the picture that comes some pictures after the one now shown.
 * @param pictures  how many further, negative for back; the cycle goes round
 */
export function pictureStep(schedule: Schedule, frame: number, pictures: number): number {
  return schedule.starts[wrap(pictureOfFrame(schedule, frame) + pictures, schedule.pictures)] ?? 0;
}
