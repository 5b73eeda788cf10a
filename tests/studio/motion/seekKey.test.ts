import { seekKey } from "../../../client-examples/studio/src/motion/seekKey";
import { kElevenOnTwos } from "./schedules";

const lead = (frame: number, key: string, shift = false) => seekKey(kElevenOnTwos, frame, key, shift);

test("SeekKey: left and right go by frame and round the cycle", () => {
  expect([lead(3, "ArrowLeft"), lead(0, "ArrowLeft"), lead(3, "ArrowRight"), lead(10, "ArrowRight")]).toEqual([2, 10, 4, 0]);
});

test("SeekKey: with shift, or up and down, by picture, to its first frame", () => {
  expect([lead(3, "ArrowRight", true), lead(3, "ArrowUp"), lead(10, "ArrowUp")]).toEqual([4, 4, 0]);
  expect([lead(3, "ArrowLeft", true), lead(3, "ArrowDown"), lead(1, "ArrowDown")]).toEqual([0, 0, 10]);
});

test("SeekKey: Home and End; other keys are left alone", () => {
  expect([lead(3, "Home"), lead(3, "End"), lead(3, "a"), lead(3, "Tab")]).toEqual([0, 10, null, null]);
});
