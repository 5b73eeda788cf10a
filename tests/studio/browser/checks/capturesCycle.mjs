import assert from "node:assert/strict";
import { hairstyle, twoTufts } from "../hairstyles.mjs";

const kTimings = [
  { period: 11 / 24, fps: 24, hold: 2 }, // the paper's: 11 frames, the last held once
  { period: 0.5, fps: 24, hold: 3 },
  { period: 8 / 25, fps: 25, hold: 1 },
  { period: 11 / 24, fps: 24, hold: 2, short_holds: "spread" },
];

async function scheduleOf(studio, timing) {
  const answer = await studio.page.request.post(new URL("/v1/schedules", studio.page.url()).href, { data: { timing } });
  return (await answer.json()).schedule;
}

/** Every frame of a cycle shows the picture that the service's schedule has there, and no two pictures are the same. */
export async function capturesCycle({ open, say }) {
  for (const timing of kTimings) {
    const studio = await open({ width: 620, height: 440, kept: hairstyle(twoTufts(), timing) });
    const { starts, holds, frames, pictures } = await scheduleOf(studio, timing);
    await studio.mode("Move");
    const sheet = studio.page.getByRole("slider", { name: "Exposure sheet" });
    await sheet.focus();
    await studio.press("Home");
    const shown = [];
    for (let frame = 0; frame < frames; frame++) {
      assert.equal(await sheet.getAttribute("aria-valuenow"), String(frame + 1));
      shown.push((await studio.look()).hash);
      await studio.press("ArrowRight");
    }
    const expected = starts.flatMap((start, picture) => Array.from({ length: holds[picture] }, () => shown[start]));
    assert.deepEqual(shown, expected, `each picture is held as long as the schedule says: ${holds}`);
    assert.equal(new Set(shown).size, pictures, "no two pictures are the same");
    assert.equal((await studio.look()).hash, shown[0], "after the last frame comes the first");
    say(`${frames} frames at ${timing.fps} fps: ${pictures} pictures held ${holds.join(" ")}`);
    await studio.page.context().close();
  }
}
