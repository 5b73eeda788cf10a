import { frameRate } from "../../../client-examples/studio/src/motion/frameRate";

test("FrameRate: numbers and fractions", () => {
  expect(frameRate(24)).toBe(24);
  expect(frameRate("30")).toBe(30);
  expect(frameRate("24000/1001")).toBe(24000 / 1001);
});

test("FrameRate: what is none is refused", () => {
  for (const wrong of [0, -24, Number.NaN, Number.POSITIVE_INFINITY, "", "24/0", "0/1", "1/2/3", "fast"])
    expect(() => frameRate(wrong), String(wrong)).toThrow(RangeError);
});
