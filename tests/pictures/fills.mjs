// Requests whose hair is filled: the paper's two tufts step by step, and a whole head from six.
import { kPlaces } from "./page/places.mjs";
import { scalpAt } from "./scalp.mjs";

const kHead = { center: [0, 0, 0], root_depth: 0.012, diameter_at_100: 0.1, scalp: scalpAt(kPlaces.filled) };

/** A point about the head: degrees from the face to the character's left, degrees up, metres from the center. */
const at = (turn, up, distance) => {
  const [t, u] = [(turn * Math.PI) / 180, (up * Math.PI) / 180];
  return [Math.cos(u) * Math.sin(t), Math.sin(u), Math.cos(u) * Math.cos(t)].map((x) => +(distance * x).toFixed(5));
};
const along = (...places) => places.map((place) => at(...place));
const flat = { section: "ellipse", flatness: 0.55 };

// Figures 10 and 11: from one side of the forehead around the back to the other.
const kSpikes = [
  { name: "left", points: along([22, 40, 0.1], [26, 28, 0.142], [34, 8, 0.172]), diameter: 66, widest_at: 35, ...flat },
  { name: "right", points: along([-22, 40, 0.1], [-26, 28, 0.142], [-34, 8, 0.172]), diameter: 66, widest_at: 35, ...flat },
];
const spikes = (fill) => ({ head: kHead, tufts: kSpikes, fills: fill ? [{ from: "left", to: "right", ...fill }] : [] });

// Six drawn tufts.
const kBob = [
  { name: "fringe_R", points: along([-46, 66, 0.1], [-46, 44, 0.113], [-42, 18, 0.12], [-30, -14, 0.118]), diameter: 60, widest_at: 52, ...flat },
  { name: "fringe_L", points: along([40, 66, 0.1], [44, 44, 0.113], [46, 18, 0.12], [48, -14, 0.12]), diameter: 60, widest_at: 52, ...flat },
  { name: "side_L", points: along([52, 62, 0.1], [58, 38, 0.115], [62, 0, 0.118], [56, -36, 0.128], [46, -54, 0.152]), diameter: 62, widest_at: 50, ...flat },
  { name: "back", points: along([180, 58, 0.1], [180, 34, 0.122], [180, -4, 0.13], [180, -38, 0.138], [180, -53, 0.162]), diameter: 72, widest_at: 55, ...flat },
  { name: "side_R", points: along([-52, 62, 0.1], [-58, 38, 0.115], [-62, 0, 0.118], [-56, -36, 0.128], [-46, -54, 0.152]), diameter: 62, widest_at: 50, ...flat },
  { name: "ahoge", points: along([5, 85, 0.1], [20, 80, 0.13], [60, 68, 0.15], [80, 58, 0.142]), diameter: 12, widest_at: 35 },
];
const kBobFills = [
  { name: "front", from: "fringe_R", to: "fringe_L", density: { along: 60, crown: 80 }, min_gap: 0.25 },
  { name: "backL", from: "side_L", to: "back", density: { along: 70, crown: 90 }, min_gap: 0.15 },
  { name: "backR", from: "back", to: "side_R", density: { along: 70, crown: 90 }, min_gap: 0.15 },
];

export const kFills = {
  "spiky-two": spikes(null),
  "spiky-along": spikes({ density: { along: 75 } }),
  "spiky-crown": spikes({ density: { along: 75, crown: 75 }, min_gap: 0.4 }),
  "spiky-neck": spikes({ density: { along: 75, crown: 75, neck: 80 }, min_gap: 0.4 }),
  "spiky-jitter": spikes({ density: { along: 75, crown: 75, neck: 80 }, min_gap: 0.4, jitter: { seed: 3 } }),
  "bob-drawn": { head: kHead, tufts: kBob },
  "bob-none": { head: kHead, tufts: kBob, fills: kBobFills },
};
