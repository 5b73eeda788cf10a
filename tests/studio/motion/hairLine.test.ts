import { hairLine } from "../../../client-examples/studio/src/motion/hairLine";
import { picturePhases } from "../../../client-examples/studio/src/motion/picturePhases";
import { kElevenOnTwos } from "./schedules";
import { kServicePoses } from "./servicePoses";

test("HairLine: lies where the service poses a straight chain along the wind", () => {
  for (const { wave, sampling, picture, line } of kServicePoses) {
    const phase = picturePhases(kElevenOnTwos, sampling)[picture] ?? Number.NaN;
    const drawn = hairLine(wave, phase, 5);
    expect(drawn).toHaveLength(6);
    drawn.forEach(([x, y], i) => {
      expect(x).toBeCloseTo(line[i]?.[0] ?? Number.NaN, 6);
      expect(y).toBeCloseTo(line[i]?.[1] ?? Number.NaN, 6);
    });
  }
});

test("HairLine: bones keep their length however wild the wave", () => {
  const line = hairLine({ amplitude: 100, spatial_period: 0.05, lightness: 0.05, tip_exponent: 8 }, 1, 16);
  for (let i = 1; i < line.length; ++i) {
    const [[x0, y0], [x1, y1]] = [line[i - 1] ?? [0, 0], line[i] ?? [0, 0]];
    expect(Math.sqrt((x1 - x0) ** 2 + (y1 - y0) ** 2)).toBeCloseTo(Math.PI / 16, 12);
  }
});

test("HairLine: without amplitude it is the straight line, and one segment is a line too", () => {
  const still = { amplitude: 0, spatial_period: 1, lightness: 1.2, tip_exponent: 1 };
  expect(hairLine(still, 2, 1)).toEqual([[0, 0], [Math.PI, expect.closeTo(0, 12)]]);
});
