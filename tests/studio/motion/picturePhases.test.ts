import { picturePhases } from "../../../client-examples/studio/src/motion/picturePhases";
import { kElevenOnTwos } from "./schedules";

test("PicturePhases: evenly over the cycle unless asked otherwise", () => {
  expect(picturePhases(kElevenOnTwos)).toEqual([0, 1, 2, 3, 4, 5].map((n) => 2 * Math.PI * (n / 6)));
});

test("PicturePhases: by frame, each at its start", () => {
  expect(picturePhases(kElevenOnTwos, "by_frame")).toEqual([0, 2, 4, 6, 8, 10].map((start) => 2 * Math.PI * (start / 11)));
});

test("PicturePhases: two waves per loop go round twice", () => {
  expect(picturePhases(kElevenOnTwos, "uniform", 2)).toEqual([0, 2, 4, 0, 2, 4].map((n) => 2 * Math.PI * (n / 6)));
});
