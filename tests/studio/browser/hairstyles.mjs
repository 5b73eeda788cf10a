/** A point about the head: degrees from the face to the character's left, degrees up, meters from the head's center. */
const at = (turn, up, distance) => {
  const [t, u] = [(turn * Math.PI) / 180, (up * Math.PI) / 180];
  return [Math.cos(u) * Math.sin(t), Math.sin(u), Math.cos(u) * Math.cos(t)].map((x) => +(distance * x).toFixed(5));
};

const kHead = { center: [0, 0, 0], root_depth: 0.012, diameter_at_100: 0.1, scalp: null };
const kFlat = { section: "ellipse", flatness: 0.55 };
const kWave = { amplitude: 0.3, spatial_period: 1, lightness: 1.2, tip_exponent: 1.5 };

/** What the page would have kept of a visit. @param timing  of the motion */
export function hairstyle(tufts, timing = { period: 0.45, fps: 24, hold: 2 }) {
  const motion = { wave: kWave, timing, wind: [1, 0, 0], one_sided: true, phase: { gust_wavelength: 0.8, spread: 0.08, seed: 7 } };
  return { name: "test", hairstyle: { head: kHead, tufts, motion, mesh: { color: "#e8638c" } } };
}

/** Two locks at the sides of the forehead, apart enough to fill between; both in sight from where the page looks first. */
export function twoTufts() {
  const lock = (name, turn) => ({ name, points: [at(turn, 50, 0.1), at(turn, 35, 0.135), at(turn, 12, 0.15), at(turn, -10, 0.15)], diameter: 60, widest_at: 40, ...kFlat });
  return [lock("left", -8), lock("right", -58)];
}

/** A whole head of `count` locks of four points. */
export function wholeHead(count) {
  return Array.from({ length: count }, (_, i) => {
    const turn = (i * 137.508) % 360;
    const up = 80 - 75 * Math.sqrt((i + 0.5) / count);
    return { name: `lock_${i + 1}`, points: [at(turn, up, 0.1), at(turn, up - 12, 0.125), at(turn, up - 30, 0.13), at(turn, up - 50, 0.135)], diameter: 24, widest_at: 40, ...kFlat };
  });
}
