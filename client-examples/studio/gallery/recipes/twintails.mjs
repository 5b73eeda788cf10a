import { color, motion, pair, pen, stroke } from "../steps.mjs";

/** From further away, so that the tails fit. */
export const isNear = false;

/** Twin tails: the hair parted at the back and tied high on both sides. */
export const steps = [
  color("#e8638c"),
  pen({ thickness: 50, widest: 38, flat: 0.72, taper: "round" }),
  pair("part_1", "back 0 2", [0.4, 8.4], [3.6, 7.4], [7.2, 4.4], [8.8, 2.4]),
  pair("part_2", "back 0 2", [0.3, 4.5], [3.6, 4.4], [7, 3], [9, 1.4]),
  pair("part_3", "back 0 1", [0.3, 0.5], [3.6, 1.4], [7, 2.4], [9, 3]),
  pair("part_4", "back", [0.3, -4.5], [3.4, -3], [6.6, 0.5], [8.8, 3.2]),
  pair("part_5", "back", [0.6, -8.2], [3, -7.2], [6.2, -2], [8.8, 3]),
  pair("temple_1", "left", [-7.6, 0.5], [-4.4, 0.9], [-0.6, 2.4], [2, 3.6]),
  pair("temple_2", "left", [1.6, -1.4], [2, 0], [2.2, 2], [2.4, 3.6]),
  pair("temple_3", "left", [6.5, -7], [5.6, -3], [4, 1], [2.6, 3.4]),
  pair("top_1", "left 0 2", [-0.4, 9.5], [-2.4, 6.4], [-0.4, 3], [1.6, 0.6]),
  pair("top_2", "left 0 2", [1, 9.4], [1.4, 6.6], [1.8, 3], [2.2, 0.6]),
  pen({ thickness: 70, widest: 38, flat: 0.35, taper: "sine", joints: 12 }),
  pair("tail_1", "front", [8.4, 4.6], [12, 6.4], [15.4, 1], [16, -9], [14, -21]),
  pair("tail_2", "front", [8.5, 4.2], [11.4, 4.8], [13, -2], [13.2, -11], [11.4, -22.5]),
  pen({ thickness: 42 }),
  pair("tail_3", "front", [8.4, 4.8], [12.6, 7.4], [17.4, 2], [18.4, -7], [17.4, -17]),
  pair("tail_4", "front 2", [8.5, 4.2], [11, 4.6], [12.6, -2], [12, -10], [12.8, -18.5]),
  pen({ thickness: 40, widest: 60, flat: 0.6, joints: 6 }),
  stroke("fringe", "front 0 2", [0.3, 8.9], [0.9, 4], [1.2, -2], [0, -8.6]),
  stroke("fringe_a", "front 0 2", [0.8, 8.9], [3.4, 4.4], [4.2, -2], [3.4, -8.6]),
  stroke("fringe_b", "front 0 2", [-0.4, 8.9], [-2, 4], [-2.2, -2], [-2.9, -8.2]),
  stroke("fringe_d", "front 0 2", [-0.8, 8.9], [-3.6, 4.6], [-4.6, -2], [-5, -8.6]),
  pair("fringe_c", "front 0 2", [1.2, 8.9], [5.2, 4.6], [6.6, -2], [6.4, -9]),
  pen({ thickness: 30, widest: 45, flat: 0.5, joints: 8 }),
  pair("lock", "front 0 2", [2, 8.9], [6.6, 4.4], [8.6, -3], [8.4, -11], [9.2, -18.6]),
  motion({ amplitude: 0.42, spatial_period: 1, lightness: 1.3, tip_exponent: 1.4, period: 0.5, hold: 2, spread: 0.06, gust: 0.8 }),
];
