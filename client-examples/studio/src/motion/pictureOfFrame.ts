import type { Schedule } from "../api/contract";
import { wrap } from "./wrap";

/**
 * Which picture the exposure sheet shows.
 * @param frame  any whole number; frames outside the cycle are those of another round
 * @returns the picture, from 0
 */
export function pictureOfFrame(schedule: Schedule, frame: number): number {
  const inCycle = wrap(frame, schedule.frames);
  return schedule.starts.findLastIndex((start) => start <= inCycle);
}
