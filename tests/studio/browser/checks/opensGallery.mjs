import assert from "node:assert/strict";
import { hairstyle, twoTufts } from "../hairstyles.mjs";

/** At least four hairstyles are ready, each with its picture; one opens in one step, is seen, and the service takes it. */
export async function opensGallery({ open }) {
  const studio = await open({ kept: hairstyle(twoTufts()) });
  const { page } = studio;
  const before = await studio.kept();
  const cards = page.getByRole("dialog", { name: "Gallery" }).locator(".gallery-card");
  await studio.button("Gallery").click();
  await cards.first().waitFor();
  const count = await cards.count();
  assert.ok(count >= 4, `${count} hairstyles`);
  await page.waitForFunction(() => [...document.querySelectorAll(".gallery-card img")].every((image) => image.complete));
  const pictures = await cards.locator("img").evaluateAll((all) => all.map(({ naturalWidth, alt }) => naturalWidth > 0 && alt.length > 0));
  assert.deepEqual(pictures, pictures.map(() => true), "each card has a picture and says what is on it");
  await studio.press("Escape");
  await studio.look();
  for (let i = 0; i < count; i++) {
    await studio.button("Gallery").click();
    await cards.nth(i).click();
    await page.getByRole("dialog").waitFor({ state: "detached" });
    assert.ok((await studio.look()).changed > 1000, `hairstyle ${i + 1} is seen`);
    assert.equal(await page.locator(".stage-problem:visible").count(), 0);
    assert.ok((await studio.tufts()).length > 5);
    await studio.press("Control+z");
    assert.deepEqual(await studio.kept(), before, "opening is one step");
  }
}
