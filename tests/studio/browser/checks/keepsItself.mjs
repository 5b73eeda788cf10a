import assert from "node:assert/strict";
import { until } from "../until.mjs";

/** The hairstyle is kept in the browser shortly after each change, and is there again after a reload. */
export async function keepsItself({ open }) {
  const studio = await open();
  await studio.draw([-0.06, -0.2], [-0.1, -0.1], [-0.14, 0]);
  await studio.page.getByRole("textbox", { name: "Name of the hairstyle" }).fill("Sakura");
  const stored = () => studio.page.evaluate(() => JSON.parse(localStorage.getItem("tuftwave.document") ?? "null"));
  await until("autosave", async () => (await stored())?.name === "Sakura");
  const before = await studio.kept();
  const { hash } = await studio.look();
  await studio.page.reload();
  await studio.ready();
  assert.deepEqual(await studio.kept(), before);
  assert.equal(await studio.page.getByRole("textbox", { name: "Name of the hairstyle" }).inputValue(), "Sakura");
  await studio.page.mouse.move(0, 0);
  assert.equal((await studio.look()).hash, hash, "the same hair is seen");
}
