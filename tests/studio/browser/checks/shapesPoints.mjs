import assert from "node:assert/strict";
import { hairstyle, twoTufts } from "../hairstyles.mjs";

/** In Shape the points of the selected lock are dragged, inserted on its line, removed, and nudged by keys. */
export async function shapesPoints({ open }) {
  const studio = await open({ kept: hairstyle(twoTufts()) });
  const points = async () => (await studio.tufts())[0].points;
  await studio.mode("Shape");
  await studio.row("left").click();
  const before = await points();
  await studio.look();

  const handle = (await studio.handles("point"))[1];
  await studio.pointer.mouse([handle, [handle[0] + 25, handle[1] + 10]]);
  const dragged = await points();
  assert.notDeepEqual(dragged[2], before[2]);
  assert.deepEqual(dragged.filter((_, i) => i !== 2), before.filter((_, i) => i !== 2), "the others stay");
  assert.ok((await studio.look()).changed > 100);

  const line = await studio.linePlaces();
  await studio.page.mouse.dblclick(...line[Math.round(line.length * 0.5)]);
  assert.equal((await points()).length, before.length + 1, "a double click on the line inserts a point");
  await studio.settle();
  await studio.page.locator(".handle.is-selected").focus();
  await studio.press("Delete");
  assert.deepEqual(await points(), dragged, "Delete removes it again");

  await studio.page.locator(".handle-point").last().focus();
  await studio.press("ArrowRight", "Shift+ArrowDown");
  const nudged = await points();
  assert.notDeepEqual(nudged.at(-1), dragged.at(-1));
  await studio.press("Control+z");
  assert.deepEqual(await points(), dragged, "a run of nudges is one step");
  await studio.press("Control+z", "Control+z", "Control+z");
  assert.deepEqual(await points(), before, "back to where it began");
}
