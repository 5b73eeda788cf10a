import type { Schedule } from "../../../client-examples/studio/src/api/contract";

/** Schedules by the service's rule, short holds last. It is written again here so that the tests need no service. */
export function scheduleOf(frames: number, hold: number, fps: number | string): Schedule {
  const pictures = Math.ceil(frames / hold);
  const [q, r] = [Math.floor(frames / pictures), frames % pictures];
  const starts = Array.from({ length: pictures }, (_, n) => n * q + Math.min(n, r));
  const holds = starts.map((start, n) => (starts[n + 1] ?? frames) - start);
  const [top = 1, bottom = 1] = String(fps).split("/").map(Number);
  const period = (frames * bottom) / top;
  return { frames, pictures, holds, starts, fps, requested_period: period, period };
}

/** Answers of POST /v1/schedules: 24 fps, 0.45 s on twos; 25 fps, 1 s on twos with its short hold spread. */
export const kElevenOnTwos: Schedule = {
  frames: 11, pictures: 6, holds: [2, 2, 2, 2, 2, 1], starts: [0, 2, 4, 6, 8, 10], fps: 24, requested_period: 0.45, period: 0.4583333333333333,
};
export const kSpread: Schedule = {
  frames: 25, pictures: 13, holds: [1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2], starts: [0, 1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23],
  fps: 25, requested_period: 1, period: 1,
};

/** All timings that the pages use: ones, twos, threes at the three usual rates, cycles of 1 frame to 2 seconds. */
export const kSchedules: readonly Schedule[] = [
  kElevenOnTwos,
  kSpread,
  ...[24, 30, "24000/1001"].flatMap((fps) => [1, 2, 3].flatMap((hold) => [1, 2, 5, 7, 11, 23, 24, 48].map((frames) => scheduleOf(frames, hold, fps)))),
];
