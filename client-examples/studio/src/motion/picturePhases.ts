import type { Schedule, Timing } from "../api/contract";

/**
 * When each picture samples the wave, from the integers alone, so that a cycle closes exactly.
 * @param sampling  evenly over the cycle, or each at the frame where it starts
 * @returns one phase per picture, radians, from 0 and below 2 pi
 */
export function picturePhases(schedule: Schedule, sampling: Timing["sampling"] = "uniform"): number[] {
  return schedule.starts.map((start, n) => (2 * Math.PI * (sampling === "by_frame" ? start / schedule.frames : n / schedule.pictures)));
}
