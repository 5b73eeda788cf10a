import type { Schedule, Timing } from "../api/contract";
import { wrap } from "./wrap";

/**
 * When each picture samples the wave, from the integers alone, so that a cycle closes exactly.
 * @param sampling  evenly over the cycle, or each at the frame where it starts
 * @param cycles  waves per loop
 * @returns one phase per picture, radians, from 0 and below 2 pi
 */
export function picturePhases({ starts, frames, pictures }: Schedule, sampling: Timing["sampling"] = "uniform", cycles = 1): number[] {
  const whole = sampling === "by_frame" ? frames : pictures;
  return starts.map((start, n) => 2 * Math.PI * (wrap(cycles * (sampling === "by_frame" ? start : n), whole) / whole));
}
