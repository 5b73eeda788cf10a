import { color, fill, motion, pair, pen, stroke } from "../steps.mjs";

/** Long straight hair with a straight fringe and side locks cut at the jaw: a hime cut. */
export const steps = [
  color("#6f5fb0"),
  pen({ thickness: 62, widest: 86, flat: 0.7, taper: "sine", joints: 10 }),
  stroke("under", "back", [0, 2.5], [0, -4], [0, -9], [0, -16], [0, -23]),
  pair("under_side", "left", [2.4, 3], [3, -3], [3.6, -9], [4, -16], [4.4, -22.4]),
  fill("under", "under_side_L", { along: 45, seed: 21 }),
  fill("under", "under_side_R", { along: 45, seed: 22 }),
  pen({ thickness: 66, widest: 62 }),
  stroke("back", "back 0 1", [0, 9.2], [0, 5], [0, -4], [0, -13], [0, -23.6]),
  pair("back_1", "back 0 1", [0.4, 9.2], [3.6, 6.2], [4.6, -3], [4.8, -13], [4.6, -23]),
  pair("back_2", "back 0 1", [0.8, 9.2], [6.4, 6.2], [8.4, -2], [8.2, -12], [7.6, -23.6]),
  pair("side", "left 0 1", [1.4, 9.5], [2.8, 5.6], [3.4, -3], [4.2, -12], [4.8, -22.4]),
  pair("side_1", "left 0 1", [0.9, 9.5], [0.4, 6], [0.4, -2], [1.2, -11], [1.8, -23]),
  pair("side_2", "left 0 1", [2, 9.4], [5.4, 5], [6, -3], [6.4, -12], [7, -21.6]),
  pen({ thickness: 46, widest: 100, flat: 0.7, taper: "round", joints: 6 }),
  pair("hime", "left 0 2", [-0.2, 9.4], [-3.8, 6], [-5, -2], [-5.2, -9], [-5.2, -15.4]),
  pair("hime_1", "left 0 2", [0.4, 9.5], [-1.8, 6], [-2.6, -2], [-3, -9], [-3, -15.4]),
  pen({ thickness: 30, widest: 97, flat: 0.6 }),
  stroke("fringe", "front 0 2", [0, 8.9], [0, 5], [0, -2], [0, -8.9]),
  pair("fringe_1", "front 0 2", [0.5, 8.9], [1.6, 5.4], [1.9, -2], [1.9, -8.5]),
  pair("fringe_2", "front 0 2", [0.9, 8.9], [3.2, 5.4], [3.8, -2], [3.8, -8.1]),
  pair("fringe_3", "front 0 2", [1.2, 8.8], [4.8, 5.2], [5.7, -2], [5.6, -8.2]),
  pair("fringe_4", "front 0 2", [1.6, 8.8], [6.2, 5.2], [7.4, -2], [7.3, -8.3]),
  motion({ amplitude: 0.22, spatial_period: 1.2, lightness: 1.6, tip_exponent: 1.8, period: 0.75, hold: 3, spread: 0.05, gust: 1.2 }),
];
