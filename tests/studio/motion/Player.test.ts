import { Player } from "../../../client-examples/studio/src/motion/Player";
import { frameRate } from "../../../client-examples/studio/src/motion/frameRate";
import { pictureOfFrame } from "../../../client-examples/studio/src/motion/pictureOfFrame";
import { kElevenOnTwos, kSchedules, scheduleOf } from "./schedules";

/** A player on a clock that starts at an awkward time and is set by hand. */
function playerOn(schedule: Parameters<Player["setSchedule"]>[0], start = 12345.678) {
  const clock = { ms: start };
  const player = new Player(() => clock.ms);
  player.setSchedule(schedule);
  player.tick();
  return { player, clock, start };
}

test("Player: on a clock that ticks with the frames every frame comes in order, three rounds", () => {
  for (const schedule of kSchedules) {
    const { player, clock, start } = playerOn(schedule);
    player.play();
    for (let n = 0; n < 3 * schedule.frames; ++n) {
      clock.ms = start + (1000 * n) / frameRate(schedule.fps);
      player.tick();
      expect(player.frame).toBe(n % schedule.frames);
      expect(player.picture).toBe(pictureOfFrame(schedule, n));
    }
  }
});

test("Player: on a 60 Hz screen each frame is what real time says, and pictures change nowhere else", () => {
  for (const schedule of kSchedules) {
    const { player, clock, start } = playerOn(schedule);
    player.play();
    let [before, shown] = [0, 0];
    for (let screen = 1; screen < 400; ++screen) {
      clock.ms = start + (1000 * screen) / 60;
      const changed = player.tick();
      const due = Math.floor((screen / 60) * frameRate(schedule.fps) + 1e-6) % schedule.frames;
      expect(player.frame).toBe(due);
      expect(changed).toBe(due !== before);
      if (player.picture !== shown) expect(changed).toBe(true);
      [before, shown] = [due, player.picture];
    }
  }
});

test("Player: after an hour it is still on time", () => {
  const { player, clock, start } = playerOn(scheduleOf(48, 3, "24000/1001"));
  player.play();
  // In ticks of 5.005 s, which are 120 frames: the cycle's middle and its start in turn.
  for (let n = 1; n <= 720; ++n) {
    clock.ms = start + n * 5005;
    player.tick();
    expect(player.frame).toBe((n * 120) % 48);
  }
});

test("Player: the smooth place runs between the frames", () => {
  const { player, clock, start } = playerOn(kElevenOnTwos);
  player.play();
  clock.ms = start + 1000 * (2.5 / 24);
  player.tick();
  expect(player.frame).toBe(2);
  expect(player.phase01).toBeCloseTo(2.5 / 11, 9);
});

test("Player: a pause stops the clock, and play goes on from there", () => {
  const { player, clock } = playerOn(kElevenOnTwos);
  player.play();
  clock.ms += 1000 * (2.5 / 24);
  player.toggle();
  clock.ms += 5000;
  expect([player.playing, player.tick(), player.tick(), player.frame]).toEqual([false, true, false, 2]);
  player.toggle();
  clock.ms += 1000 * (1 / 24);
  player.tick();
  expect([player.playing, player.frame]).toEqual([true, 3]);
});

test("Player: steps stop it and go round", () => {
  const { player, clock } = playerOn(kElevenOnTwos);
  player.play();
  player.step(-1);
  expect([player.playing, player.frame, player.picture]).toEqual([false, 10, 5]);
  player.stepPicture(1);
  expect(player.frame).toBe(0);
  player.stepPicture(-1);
  expect(player.frame).toBe(10);
  player.step(-3);
  player.stepPicture(-1);
  expect([player.frame, player.picture]).toEqual([4, 2]);
  clock.ms += 5000;
  player.tick();
  expect(player.frame).toBe(4);
});

test("Player: a seek goes to the frame's beginning, is told by the next tick, and plays on", () => {
  const { player, clock } = playerOn(kElevenOnTwos);
  player.play();
  clock.ms += 1000 * (0.7 / 24);
  player.seek(7);
  expect([player.frame, player.picture, player.tick()]).toEqual([7, 3, true]);
  clock.ms += 1000 * (0.99 / 24);
  expect([player.tick(), player.frame]).toEqual([false, 7]);
  clock.ms += 1000 * (0.02 / 24);
  expect([player.tick(), player.frame]).toEqual([true, 8]);
});

test("Player: another schedule keeps the place in the cycle, also over a gap without one", () => {
  const { player } = playerOn(kElevenOnTwos);
  player.seek(5);
  player.setSchedule(scheduleOf(48, 3, 24));
  expect([player.frame, player.tick()]).toEqual([Math.floor((5 / 11) * 48), true]);
  player.setSchedule(null);
  expect([player.frame, player.picture]).toEqual([0, 0]);
  player.setSchedule(kElevenOnTwos);
  expect(player.frame).toBe(5);
});

test("Player: a frame rate that is none is refused and changes nothing", () => {
  const { player } = playerOn(kElevenOnTwos);
  expect(() => player.setSchedule({ ...kElevenOnTwos, fps: "24/0" })).toThrow(RangeError);
  expect(player.schedule).toBe(kElevenOnTwos);
});
