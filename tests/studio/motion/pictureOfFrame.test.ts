import { pictureOfFrame } from "../../../client-examples/studio/src/motion/pictureOfFrame";
import { kElevenOnTwos, kSchedules, kSpread } from "./schedules";

test("PictureOfFrame: eleven frames on twos show the last picture for one frame", () => {
  expect(Array.from({ length: 11 }, (_, frame) => pictureOfFrame(kElevenOnTwos, frame))).toEqual([0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5]);
});

test("PictureOfFrame: a spread short hold comes first", () => {
  expect([0, 1, 2, 3, 24].map((frame) => pictureOfFrame(kSpread, frame))).toEqual([0, 1, 1, 2, 12]);
});

test("PictureOfFrame: in every schedule each picture is shown as long as it is held, in order", () => {
  for (const schedule of kSchedules) {
    const shown = Array.from({ length: schedule.frames }, (_, frame) => pictureOfFrame(schedule, frame));
    expect(shown).toEqual(schedule.holds.flatMap((hold, picture) => Array<number>(hold).fill(picture)));
  }
});

test("PictureOfFrame: frames outside the cycle are those of another round", () => {
  for (const schedule of kSchedules)
    for (let frame = 0; frame < schedule.frames; ++frame)
      for (const round of [-2, -1, 1, 1000])
        expect(pictureOfFrame(schedule, frame + round * schedule.frames)).toBe(pictureOfFrame(schedule, frame));
});
