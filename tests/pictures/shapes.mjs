// Requests for one tuft each: the same stroke in different shapes, and strokes that turn tighter than the tuft is thick.
const kHead = { center: [0, 0.1, -0.3], diameter_at_100: 0.1, root_depth: 0 };
const kStroke = [[0, 0.22, 0], [0.012, 0.175, 0.012], [0.014, 0.12, 0.016], [0.002, 0.065, 0.01], [-0.014, 0.02, 0], [-0.018, -0.01, -0.004]];

const still = (tuft, mesh = {}) => ({ head: kHead, tufts: [{ name: "tuft", ...tuft }], mesh: { sides: 32, tolerance: 0.0001, ...mesh } });
const shape = (fields) => still({ points: kStroke, diameter: 60, ...fields });
const around = (count, point) => Array.from({ length: count }, (_, i) => point(i / (count - 1)));

// Turns on a circle of 9 mm; the tuft's radius is 16 mm.
const kHairpin = [
  [-0.03, 0.2, 0], [-0.016, 0.13, 0], [-0.009, 0.07, 0],
  ...around(5, (t) => [-0.009 * Math.cos(Math.PI * t), 0.04 - 0.009 * Math.sin(Math.PI * t), 0.002 * t]),
  [0.01, 0.07, 0.003], [0.02, 0.12, 0.004], [0.04, 0.17, 0.004],
];
// Three and a half turns on a circle of 11 mm; the tuft's radius is 13 mm.
const kRinglet = [[0, 0.22, 0], ...around(29, (t) => [0.011 * Math.sin(7 * Math.PI * t), 0.185 - 0.18 * t, 0.011 * Math.cos(7 * Math.PI * t)])];

export const kShapes = {
  "d25-p10": shape({ diameter: 25, widest_at: 10 }),
  "d25-p80": shape({ diameter: 25, widest_at: 80 }),
  "d100-p10": shape({ diameter: 100, widest_at: 10 }),
  "d100-p80": shape({ diameter: 100, widest_at: 80 }),
  sine: shape({ taper: "sine" }),
  linear: shape({ taper: "linear" }),
  smooth: shape({ taper: "smooth" }),
  round: shape({ taper: "round" }),
  flat: shape({ diameter: 80, section: "ellipse", flatness: 0.75 }),
  edge: shape({ diameter: 80, section: "ellipse", flatness: 0.75, roll_deg: 90 }),
  twist: shape({ diameter: 80, section: "ellipse", flatness: 0.75, twist_deg: 540 }),
  cap: shape({ widest_at: 100 }),
  hairpin: still({ points: kHairpin, diameter: 32, widest_at: 50, taper: "round" }),
  ringlet: still({ points: kRinglet, diameter: 26, widest_at: 30, taper: "round" }),
};
