import { WaveShape } from "../../../client-examples/studio/src/motion/WaveShape";
import { picturePhases } from "../../../client-examples/studio/src/motion/picturePhases";
import { kElevenOnTwos } from "./schedules";

const kPaper = { amplitude: 0.8, spatial_period: 1, lightness: 1.2, tip_exponent: 1 };

test("WaveShape: the tip's path is closed and passes through every picture's tip", () => {
  const shape = new WaveShape(kPaper, picturePhases(kElevenOnTwos), 12);
  const [first, last] = [shape.tipPath[0], shape.tipPath[shape.tipPath.length - 1]];
  expect(last?.[0]).toBeCloseTo(first?.[0] ?? Number.NaN, 9);
  expect(last?.[1]).toBeCloseTo(first?.[1] ?? Number.NaN, 9);
  for (const hair of shape.hairs) {
    const [x, y] = hair[12] ?? [Number.NaN, Number.NaN];
    expect(Math.min(...shape.tipPath.map((point) => Math.max(Math.abs(point[0] - x), Math.abs(point[1] - y))))).toBeLessThan(0.02);
  }
});

test("WaveShape: the tip swings no further than the hair and droops, or rises for a negative amplitude", () => {
  const drooping = new WaveShape(kPaper, [0], 12);
  expect(drooping.bottom).toBeLessThanOrEqual(drooping.tipBottom);
  expect(drooping.top).toBeGreaterThanOrEqual(drooping.tipTop);
  // Droop is -a/s^2, whatever the sign of s; a negative amplitude is what lifts the hair.
  expect(drooping.tipTop + drooping.tipBottom).toBeLessThan(0);
  const lifted = new WaveShape({ ...kPaper, amplitude: -0.8 }, [0], 12);
  expect(lifted.tipTop + lifted.tipBottom).toBeGreaterThan(0);
});

test("WaveShape: the wildest wave stays finite, and a hair stays as long as it is", () => {
  const shape = new WaveShape({ amplitude: 100, spatial_period: 0.05, lightness: -0.05, tip_exponent: 8 }, [0, 1, 2], 20);
  for (const height of [shape.bottom, shape.top]) expect(Math.abs(height)).toBeLessThanOrEqual(Math.PI + 1e-9);
  expect(shape.curves.flat(2).every(Number.isFinite)).toBe(true);
});
