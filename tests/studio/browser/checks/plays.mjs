import assert from "node:assert/strict";
import { hairstyle, twoTufts } from "../hairstyles.mjs";
import { until } from "../until.mjs";

/** Move plays by itself unless less motion is wished for; the sheet follows, is scrubbed, and onion skin and comparison change the picture. */
export async function plays({ open }) {
  const kept = hairstyle(twoTufts(), { period: 1, fps: 24, hold: 2 });
  const studio = await open({ reducedMotion: "no-preference", kept });
  const sheet = studio.page.getByRole("slider", { name: "Exposure sheet" });
  const frame = async () => Number(await sheet.getAttribute("aria-valuenow"));
  await studio.mode("Move");
  const first = await frame();
  await until("another frame", async () => (await frame()) !== first);
  await studio.button("Pause").click();

  await studio.button("First frame").click();
  assert.equal(await frame(), 1);
  const held = await studio.look();
  await studio.button("Next picture").click();
  assert.equal(await frame(), 3, "on twos the second picture begins with frame 3");
  assert.ok((await studio.look()).changed > 100);
  assert.equal(await studio.page.locator(".sheet-column.lit").count(), 2, "the sheet lights the frames of the picture");
  await studio.button("Previous picture").click();
  assert.equal((await studio.look()).hash, held.hash);

  const columns = await studio.page.locator(".sheet-column").evaluateAll((all) => all.slice(0, 6).map((one) => one.getBoundingClientRect()).map(({ x, y, width, height }) => [x + width / 2, y + height / 2]));
  await studio.pointer.mouse([columns[1], columns[3], columns[5]]);
  assert.equal(await frame(), 6, "scrubbed to the sixth frame");
  const scrubbed = await studio.look();
  assert.notEqual(scrubbed.hash, held.hash);

  await studio.button("Onion skin").click();
  assert.ok((await studio.look()).changed > 100, "onion skin is seen");
  await studio.button("Onion skin").click();
  assert.equal((await studio.look()).hash, scrubbed.hash);
  await studio.button("Compare with smooth").click();
  assert.ok((await studio.look()).changed > 1000, "comparison shows the head twice");
  assert.equal(await studio.page.getByText("Smooth, for comparison").isVisible(), true);
  await studio.button("Compare with smooth").click();
  assert.equal((await studio.look()).hash, scrubbed.hash);

  const calm = await open({ reducedMotion: "reduce", kept });
  await calm.mode("Move");
  const still = await calm.look();
  assert.equal(await calm.button("Play").isVisible(), true, "it waits to be started");
  assert.equal((await calm.look()).hash, still.hash);
}
