import { picturePhases } from "../../../client-examples/studio/src/motion/picturePhases";
import { wavePoint } from "../../../client-examples/studio/src/motion/wavePoint";
import { kElevenOnTwos } from "./schedules";
import { kServicePoses } from "./servicePoses";

const kPaper = { amplitude: 0.8, spatial_period: 1, lightness: 1.2, tip_exponent: 1 };

test("WavePoint: is as high as the wave that the service poses hair by", () => {
  for (const { wave, sampling, picture, heights } of kServicePoses) {
    const phase = picturePhases(kElevenOnTwos, sampling)[picture] ?? Number.NaN;
    heights.forEach((height, i) => expect(wavePoint(wave, (Math.PI * i) / 5, phase)).toBeCloseTo(height, 5));
  }
});

test("WavePoint: the tip by hand", () => {
  // cos(pi) = -1, so f = -(0.8 / 1.2) (1 / 1.2 - 1).
  expect(wavePoint(kPaper, Math.PI, 0)).toBeCloseTo(1 / 9, 12);
});

test("WavePoint: the root stands still, also where rounding puts it below 0", () => {
  for (const tip_exponent of [0.05, 1, 1.5, 8])
    for (const x of [0, -0, -1e-17]) expect(wavePoint({ ...kPaper, tip_exponent }, x, 1)).toBe(0);
});

test("WavePoint: one cycle later everything is as before", () => {
  for (const x of [0.5, 2, 3]) expect(wavePoint(kPaper, x, 1 + 2 * Math.PI)).toBeCloseTo(wavePoint(kPaper, x, 1), 12);
});
