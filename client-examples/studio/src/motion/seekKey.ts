import type { Schedule } from "../api/contract";
import { pictureStep } from "./pictureStep";
import { wrap } from "./wrap";

/**
 * Where a key leads on the exposure sheet: left and right by frame, with shift or up and down by picture, Home and End.
 * @param key  as KeyboardEvent.key
 * @returns a frame of the cycle, or null if the key has no meaning here
 */
export function seekKey(schedule: Schedule, frame: number, key: string, shift: boolean): number | null {
  switch (key) {
    case "ArrowLeft":
      return shift ? pictureStep(schedule, frame, -1) : wrap(frame - 1, schedule.frames);
    case "ArrowRight":
      return shift ? pictureStep(schedule, frame, 1) : wrap(frame + 1, schedule.frames);
    // As on every slider, up is more.
    case "ArrowDown":
      return pictureStep(schedule, frame, -1);
    case "ArrowUp":
      return pictureStep(schedule, frame, 1);
    case "Home":
      return 0;
    case "End":
      return schedule.frames - 1;
    default:
      return null;
  }
}
