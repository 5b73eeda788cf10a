import { color, fill, motion, pair, pen, plane, stroke } from "../steps.mjs";

/** Fluffy waves and an ahoge. */
export const steps = [
  color("#d8d6e6"),
  pen({ thickness: 60, widest: 60, flat: 0.5, taper: "sine", joints: 10 }),
  stroke("under", "back", [0, 2.5], [0.4, -3], [-1.2, -8], [1.4, -13], [-1, -17.4], [0.8, -21]),
  pair("under_side", "left", [1.8, 3.4], [2.2, -2], [4, -7.6], [1.6, -12.6], [4, -17], [2.6, -20.4]),
  fill("under", "under_side_L", { along: 60, seed: 11 }),
  fill("under", "under_side_R", { along: 60, seed: 12 }),
  pen({ thickness: 66, widest: 55, flat: 0.5 }),
  stroke("back", "back 0 1", [0, 9.2], [0.8, 4], [-0.8, -4], [1.4, -9], [-1.2, -13.4], [1, -18]),
  pair("back_1", "back 0 1", [0.4, 9.2], [4, 6], [5.8, -3], [3.6, -8.6], [6.6, -13], [4.2, -18.4]),
  pair("back_2", "back 0 1", [0.8, 9.2], [6.8, 6], [9.8, -2], [7.8, -8], [11.4, -12.6], [8.6, -17.4], [10, -20]),
  pair("side", "left 0 1", [1.4, 9.6], [2.8, 5.4], [2.2, -3], [4.8, -8.6], [2, -13.4], [4.8, -18]),
  pair("side_1", "left 0 1", [0.9, 9.6], [-0.4, 6], [-2, -2], [0.8, -8], [-2.2, -13], [0.6, -17.6], [-1, -20]),
  pair("cheek", "left 0 1", [0.2, 9.5], [-3.6, 6], [-5, -1], [-3, -8], [-5.8, -13], [-3.4, -17]),
  pen({ thickness: 46, widest: 60, flat: 0.55, joints: 6 }),
  stroke("fringe", "front 0 2", [-0.4, 8.9], [-0.6, 5], [0.6, -2], [2, -8.2]),
  stroke("fringe_a", "front 0 2", [0.2, 8.9], [2.6, 5.4], [4, -1.4], [5.4, -8.2]),
  stroke("fringe_b", "front 0 2", [0.8, 8.9], [5, 5.4], [6.8, -1.4], [7.8, -9.4]),
  stroke("fringe_c", "front 0 2", [-0.8, 8.9], [-3, 5.4], [-3.2, -2], [-2, -8.6]),
  stroke("fringe_d", "front 0 2", [-1.4, 8.9], [-5.2, 5.4], [-6.4, -1.4], [-6.6, -9.2]),
  pen({ thickness: 26, widest: 45, flat: 0.5, joints: 8 }),
  pair("lock", "front 0 2", [1.6, 8.8], [6.6, 5], [9, -3], [7.4, -9], [10, -14], [8, -18.4], [9, -21]),
  pen({ thickness: 18, widest: 40, flat: 0.5, joints: 10 }),
  plane("ahoge", ["front 0 2", [0.4, 9.1]], "quarter", [1.4, 12.4], [4.4, 14], [7, 12], [6.4, 9.6]),
  motion({ amplitude: 0.24, spatial_period: 1.1, lightness: 1.3, tip_exponent: 1.2, period: 1.0, hold: 3, spread: 0.25 }),
];
