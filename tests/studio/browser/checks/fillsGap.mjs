import assert from "node:assert/strict";
import { hairstyle, twoTufts } from "../hairstyles.mjs";
import { until } from "../until.mjs";

/** Two locks picked in the picture: what would fill the gap is shown, and added in one step. One picked twice: a ring. */
export async function fillsGap({ open }) {
  const studio = await open({ kept: hairstyle(twoTufts()) });
  const { page } = studio;
  const add = page.getByRole("button", { name: /^Add [1-9]\d* tufts?$/ });
  const places = [];
  await studio.mode("Shape");
  for (const name of ["left", "right"]) {
    await studio.row(name).click();
    const line = await studio.linePlaces();
    places.push(line[Math.round(line.length * 0.55)]);
  }
  await studio.page.locator(".stage-canvas").press("Escape"); // or what is selected would be picked
  await studio.mode("Fill");
  await studio.look();
  for (const place of places) await page.mouse.click(...place);
  await add.waitFor();
  assert.ok((await studio.look()).changed > 400, "the preview is seen");
  const planned = Number(/\d+/.exec(await add.textContent())[0]);
  const before = await studio.kept();
  assert.equal(before.hairstyle.tufts.length, 2, "a preview is no hair yet");

  await page.getByRole("checkbox", { name: "Scatter" }).check();
  await studio.settle();
  const seed = page.getByRole("spinbutton", { name: "Seed" });
  const seedBefore = await seed.inputValue();
  await studio.look();
  await until("another seed", async () => {
    await page.getByRole("button", { name: "Another seed" }).click();
    return (await seed.inputValue()) !== seedBefore;
  });
  assert.ok((await studio.look()).changed > 50, "another seed is another scatter");

  await add.click();
  const after = await studio.tufts();
  assert.equal(after.length, 2 + planned);
  await studio.press("Control+z");
  assert.deepEqual(await studio.kept(), before, "a fill is one step");

  await studio.settle();
  for (let i = 0; i < 2; i++) await page.mouse.click(...places[0]);
  await page.getByText("itself, a ring").waitFor();
  await add.waitFor();
  await studio.settle();
  const ring = Number(/\d+/.exec(await add.textContent())[0]);
  await add.click();
  assert.equal((await studio.tufts()).length, 2 + ring);
  assert.ok(ring > planned, `a ring of ${ring} goes all around, a gap of ${planned} does not`);
}
