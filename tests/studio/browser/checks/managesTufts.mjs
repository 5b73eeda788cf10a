import assert from "node:assert/strict";
import { hairstyle, twoTufts } from "../hairstyles.mjs";

/** Locks are selected in the picture and in the list, renamed, reordered, duplicated, mirrored and erased. */
export async function managesTufts({ open }) {
  const studio = await open({ kept: hairstyle(twoTufts()) });
  const names = async () => (await studio.tufts()).map(({ name }) => name);
  await studio.mode("Shape");

  await studio.row("left").click();
  const line = await studio.linePlaces();
  await studio.press("Escape");
  await studio.row("right").click();
  await studio.page.mouse.click(...line[Math.round(line.length * 0.55)]);
  assert.equal(await studio.row("left").getAttribute("aria-pressed"), "true", "a click on its hair selects a lock");

  await studio.row("left").dblclick();
  await studio.page.getByRole("textbox", { name: "Name", exact: true }).fill("side_L");
  await studio.press("Enter");
  assert.deepEqual(await names(), ["side_L", "right"]);

  await studio.row("side_L").click();
  await studio.button("Later in the list").click();
  assert.deepEqual(await names(), ["right", "side_L"]);
  await studio.button("Earlier in the list").click();
  assert.deepEqual(await names(), ["side_L", "right"]);

  await studio.button("Mirror across the face").click();
  const [left, , mirrored] = await studio.tufts();
  assert.equal(mirrored.name, "side_R");
  assert.deepEqual(mirrored.points, left.points.map(([x, y, z]) => [-x + 0, y, z]));

  await studio.row("side_L").click();
  await studio.button("Duplicate").click();
  const all = await studio.tufts();
  assert.deepEqual(all.at(-1).points, left.points);
  assert.equal(new Set(all.map(({ name }) => name)).size, 4, "no two have the same name");

  await studio.button("Erase").click();
  assert.deepEqual(await names(), ["side_L", "right", "side_R"]);
  await studio.row("side_L").click();
  await studio.row("side_R").click({ modifiers: ["Shift"] });
  await studio.type("Thickness", 30);
  assert.deepEqual((await studio.tufts()).map(({ diameter }) => diameter), [30, 30, 30], "what is set holds for all that are selected");
  await studio.press("Control+z");
  assert.deepEqual((await studio.tufts()).map(({ diameter }) => diameter), [60, 60, 60]);
}
