import { rangeOf } from "../api/rangeOf";
import type { Timing } from "../api/contract";

const kPictures = 24; // the most the contract allows in a cycle

/** The same period in as many pictures as can be had, to see what the held ones leave out. */
export function smoothTiming({ period }: Timing): Timing {
  const seconds = period ?? rangeOf("Period").default!;
  const fps = Math.max(1, Math.min(240, kPictures / seconds));
  return { period: seconds, fps, hold: Math.max(1, Math.ceil((fps * seconds + 0.5) / (kPictures + 0.5))) };
}
