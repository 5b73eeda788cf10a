import { color, fill, motion, pair, pen, stroke } from "../steps.mjs";

/** A short bob with a full fringe: filled below, drawn by hand above. */
export const steps = [
  color("#d17a52"),
  pen({ thickness: 58, widest: 60, flat: 0.6, taper: "sine" }),
  stroke("under", "back", [0, 2.5], [0.2, -3], [0, -8], [0.5, -12.8]),
  pair("under_side", "left", [3.4, 4], [4, -1], [3.8, -7], [2.4, -12.6]),
  fill("under", "under_side_L", { along: 62, seed: 3 }),
  fill("under", "under_side_R", { along: 62, seed: 4 }),
  pen({ thickness: 64, widest: 55, flat: 0.62 }),
  stroke("back", "back 0 2", [0, 8.8], [0.2, 4], [0.3, -4], [0, -9.5], [0.5, -12.6]),
  pair("back_1", "back 0 2", [0.4, 8.9], [3.8, 6], [5, -2.5], [4.6, -9], [3.8, -12.8]),
  pair("back_2", "back 0 2", [0.8, 9], [6.4, 6.2], [8.6, -1.5], [8.4, -8], [7, -13]),
  pair("side", "left 0 2", [1.4, 9.5], [2.6, 5.6], [3, -3], [2.2, -10], [0.8, -14.6]),
  pair("side_1", "left 0 2", [0.8, 9.5], [-0.6, 6], [-1.4, -2], [-1.8, -9], [-3.4, -14.8]),
  pair("cheek", "left 0 2", [0, 9.4], [-3.6, 6.4], [-5.2, -1], [-5, -9], [-6.6, -14.6]),
  pen({ thickness: 44, widest: 58, flat: 0.6 }),
  stroke("fringe", "front 0 2", [0.2, 8.9], [0.6, 5], [0.9, -2], [0.2, -8.4]),
  stroke("fringe_a", "front 0 2", [0.8, 8.9], [3.2, 5], [4, -2], [3.2, -8.6]),
  stroke("fringe_b", "front 0 2", [-0.4, 8.9], [-2, 5], [-2.4, -2], [-3, -8]),
  stroke("fringe_c", "front 0 2", [-0.8, 8.9], [-4.2, 5], [-5.4, -2], [-5.7, -8.8]),
  pair("fringe_d", "front 0 2", [1.4, 8.9], [5.4, 5.2], [6.8, -2], [6.2, -9]),
  pen({ thickness: 22, widest: 50, flat: 0.4 }),
  stroke("wisp", "front 0 2", [0.3, 8.9], [1.8, 5], [2.3, -2], [1.2, -9.2]),
  pair("lock", "front 0 2", [1.6, 8.8], [6.4, 5], [8.4, -3], [8, -10], [8.6, -17]),
  motion({ amplitude: 0.3, spatial_period: 1, lightness: 1.2, tip_exponent: 1.5, period: 0.45, hold: 2, spread: 0.08, gust: 0.8 }),
];
