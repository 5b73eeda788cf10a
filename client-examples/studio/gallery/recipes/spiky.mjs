import { color, motion, pair, pen, plane, stroke } from "../steps.mjs";

/** A short, spiky cut: below the hair lies on the head, above it stands off. */
export const steps = [
  color("#4fb0c6"),
  pen({ thickness: 56, widest: 35, flat: 0.5, taper: "sine", joints: 5 }),
  stroke("nape", "back", [0, 0], [0.3, -5], [0, -9], [0.6, -13]),
  pair("nape_1", "back", [3, 0.5], [4.4, -5], [4.4, -9], [5.4, -12.6]),
  pair("nape_2", "back", [5.6, 1], [7.6, -4], [7.6, -8], [9.2, -11.6]),
  pair("side", "left", [1.8, 5], [1.4, 0], [0.4, -4], [-0.6, -8.4]),
  pair("side_1", "left", [-2, 5], [-4.6, 1], [-6, -3], [-6.2, -8.4]),
  pair("side_3", "left", [0, 5], [-1.6, 1], [-2.8, -3], [-3.2, -8]),
  pair("side_2", "left", [4.6, 5], [4.8, 0], [4, -5], [3.8, -9.8]),
  pair("nape_3", "left", [6.4, 1], [6.4, -4], [6, -8], [6.6, -12.4]),
  // the back, in rows
  pen({ thickness: 60, widest: 40, flat: 0.55 }),
  pair("row_1", "back 0 1", [1.4, 5.4], [2.4, 1], [2.8, -3], [2.2, -8]),
  pair("row_2", "back 0 1", [4.4, 5.4], [6.6, 1.6], [7.6, -2], [8.6, -6.6]),
  stroke("row_3", "back 0 2", [0, 8.4], [-0.6, 5], [-0.4, 1], [0.4, -4.4]),
  pair("row_4", "back 0 2", [1.6, 8.4], [4, 5.4], [5.4, 1.6], [6.2, -3]),
  // the crown
  pair("crown_1", "top", [3, -3.4], [6, -2.4], [9.6, -0.4], [13, 2.6]),
  pair("crown_2", "left 0 1", [-3.4, 6.6], [-0.6, 5.6], [2.6, 3], [5.4, -1.6]),
  pair("crown_7", "left 0 1", [-5.6, 5], [-4.4, 2.6], [-1.6, -0.6], [1.6, -4.4]),
  pair("crown_3", "back", [5.4, 4.6], [8.6, 3], [10.6, -0.6], [13.4, -2.4]),
  pair("crown_4", "top", [1.4, 0.6], [4.4, 2.4], [8.4, 4.2], [12.6, 4.8]),
  pair("crown_5", "top", [0.8, 1.4], [3, 4.6], [5, 8], [7, 12]),
  stroke("crown_6", "top", [0, 0], [-0.6, 4], [-0.2, 8], [1, 12.6]),
  plane("top_1", ["front", [1.2, 8]], "quarter", [3.4, 11.2], [5, 13.4], [8.6, 14.8]),
  plane("top_2", ["front", [-1.6, 8]], "quarter", [0, 11], [-2, 12.6], [-5.6, 13.4]),
  plane("top_3", ["back", [0.8, 8.4]], "quarter", [-3, 11], [-4.8, 12.2], [-8.4, 12.2]),
  pen({ thickness: 46, widest: 40, flat: 0.5 }),
  stroke("fringe", "front", [0.6, 7.6], [2.4, 5], [2.2, -1], [0, -6.4]),
  stroke("fringe_a", "front", [1.4, 7.6], [4.8, 5.4], [5.6, 0], [4, -6]),
  stroke("fringe_b", "front", [0, 7.6], [-1.6, 5], [-1.6, 0], [-3.4, -5.6]),
  stroke("fringe_c", "front", [-0.8, 7.4], [-4.4, 5], [-5.2, 0], [-6.8, -5.6]),
  stroke("fringe_d", "front", [2.4, 7.4], [6.6, 5], [7.6, 0], [7.2, -6.8]),
  motion({ amplitude: 0.36, spatial_period: 0.8, lightness: 1.6, tip_exponent: 2, period: 0.3, hold: 2, spread: 0.15, gust: 0.5 }),
];
