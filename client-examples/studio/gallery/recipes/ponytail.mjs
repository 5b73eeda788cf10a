import { color, motion, pair, pen, plane, planePair, stroke } from "../steps.mjs";

/** From further round, so that the tail is seen. */
export const view = "quarter -4";

/** A high ponytail with side locks. */
export const steps = [
  color("#f2c46b"),
  // combed to the tie, from below, from the sides and from the front
  pen({ thickness: 46, widest: 45, flat: 0.82, taper: "sine" }),
  stroke("nape", "back", [0, -8.6], [0, -5], [0, 0], [0, 5]),
  pair("nape_1", "back", [2.4, -8.4], [2.2, -5], [1.6, 0], [0.4, 5]),
  pair("nape_2", "back", [5, -7.4], [5, -4], [3.4, 0.6], [0.6, 5]),
  pair("up_3", "back 2", [6.6, -3.4], [6.2, 0], [4, 3], [0.6, 5.2]),
  pair("up_2", "left 2", [-0.6, -1.4], [1.6, 1.4], [5, 4], [8.4, 5.4]),
  pair("up_1", "left 2", [-4.4, 1.8], [-1.4, 4], [3.4, 5.6], [8.2, 5.8]),
  pen({ thickness: 52 }),
  pair("top_3", "back 0 3", [7.4, 3.4], [6, 3], [3.4, 1.6], [0.6, 0]),
  pen({ thickness: 44, flat: 0.88 }),
  pair("top_2", "top", [6.2, -2.2], [6.4, -0.6], [4.6, 4], [1, 8]),
  pair("top_1", "top", [3.8, -2], [4.2, 0], [3, 4.4], [0.7, 8.2]),
  pair("top", "top", [1.3, -1.8], [1.5, 0], [1.2, 4.4], [0.3, 8.2]),
  // the tail
  pen({ thickness: 78, widest: 40, flat: 0.25, joints: 12 }),
  plane("tail", ["back", [0, 5]], "left", [11.4, 8.2], [15.2, 4.4], [15.8, -5], [13.6, -20]),
  pen({ thickness: 60, flat: 0.35 }),
  planePair("tail_1", ["back", [0.7, 4.8]], "left 2", [11.4, 7], [14.6, 2.4], [14.4, -7], [12, -20.5]),
  planePair("tail_2", ["back", [0.8, 4.4]], "left -2", [11, 6], [13.2, 1], [12.8, -8], [11, -17]),
  pen({ thickness: 34 }),
  plane("tail_3", ["back", [-0.3, 5.4]], "left -1", [12, 9.4], [16.8, 5], [18, -4], [17.2, -14.6]),
  // the fringe falls to the left
  pen({ thickness: 42, widest: 60, flat: 0.6, joints: 6 }),
  stroke("fringe", "front 0 2", [-1.2, 8.9], [-1.6, 4], [-1, -2], [0.6, -8.4]),
  stroke("fringe_a", "front 0 2", [-0.8, 8.9], [1.2, 4.4], [2.6, -2], [3.6, -8.6]),
  stroke("fringe_b", "front 0 2", [-0.6, 8.9], [3.2, 4.8], [5.4, -1.4], [6.2, -8.8]),
  stroke("fringe_c", "front 0 2", [-1.6, 8.9], [-3.2, 4.4], [-3.8, -2], [-3.4, -8.4]),
  stroke("fringe_d", "front 0 2", [-2, 8.9], [-5, 4.6], [-6.4, -2], [-6.4, -8.8]),
  pen({ thickness: 30, widest: 45, flat: 0.5, joints: 8 }),
  pair("lock", "front 0 2", [2, 8.9], [6.6, 4.4], [8.6, -3], [8.2, -11], [8.8, -20]),
  pair("lock_1", "left 0 1", [-3, 7], [-6, 1], [-6, -5], [-5.6, -11], [-6.4, -15]),
  motion({ amplitude: 0.32, spatial_period: 0.9, lightness: 1.2, tip_exponent: 1.2, period: 0.42, hold: 2, spread: 0.05, gust: 0.6 }),
];
