import assert from "node:assert/strict";
import { hairstyle, twoTufts } from "../hairstyles.mjs";

/** What has the focus: how it is named, and whether one sees that it has it. */
const focused = (page) => page.evaluate(() => {
  const element = document.activeElement;
  if (!element || element === document.body) return null;
  const styles = [element, ...(element.nextElementSibling ? [element.nextElementSibling] : [])].map((one) => getComputedStyle(one));
  const outlined = styles.some(({ outlineStyle, outlineWidth }) => outlineStyle !== "none" && parseFloat(outlineWidth) > 0);
  const stroked = element instanceof SVGElement && parseFloat(getComputedStyle(element).strokeWidth) >= 3;
  const label = element.getAttribute("aria-label") ?? element.labels?.[0]?.textContent ?? element.textContent;
  return { id: `${element.tagName} ${element.type ?? ""} ${label.trim()}`, isSeen: outlined || stroked };
});

/** Everything that can be used, but for the other buttons of a row of radio buttons, which arrow keys reach. */
const usable = (page) => page.evaluate(() => [...document.querySelectorAll("button, input, select, a[href], summary, [tabindex='0']")]
  .filter((one) => one.tabIndex >= 0 && !one.disabled && one.checkVisibility() && !(one.type === "radio" && !one.checked)).length);

/** Without a pointer: Tab reaches everything and one sees where it is; keys change the mode, turn, nudge, play and undo. */
export async function worksByKeys({ open }) {
  const studio = await open({ kept: hairstyle(twoTufts()) });
  const { page } = studio;
  const names = [];
  for (const [key, name] of [["1", "Draw"], ["3", "Fill"], ["4", "Move"], ["2", "Shape"]]) {
    await studio.press(key);
    assert.equal(await page.locator('.mode[aria-pressed="true"]').textContent(), name);
    if (name === "Shape") await studio.row("left").focus();
    if (name === "Shape") await studio.press("Enter");
    await studio.settle();
    while (await focused(page)) await studio.press("Tab"); // past the end, from where it begins anew
    const count = await usable(page);
    const reached = [];
    for (;;) {
      await studio.press("Tab");
      const one = await focused(page);
      if (!one || reached.length > count + 5) break;
      assert.ok(one.isSeen, `${name}: the focus on "${one.id}" is not seen`);
      reached.push(one.id);
    }
    assert.ok(reached.length >= count, `${name}: Tab reaches ${reached.length} of ${count}: ${reached.join("; ")}`);
    names.push(...reached);
  }
  assert.ok(names.every((id) => id.split(" ").length > 1), "everything has a name");

  const before = await studio.kept();
  const front = await studio.look();
  await page.locator(".handle-point").last().focus();
  await studio.press("ArrowLeft", "ArrowLeft");
  assert.notDeepEqual(await studio.kept(), before, "a point is nudged");
  assert.ok((await studio.look()).changed > 20);
  await studio.press("Control+z");
  assert.deepEqual(await studio.kept(), before);

  await page.locator(".stage-canvas").focus();
  await studio.press("ArrowRight", "+");
  assert.notEqual((await studio.look()).hash, front.hash, "the view is turned and brought nearer");

  await studio.press("4");
  await studio.settle();
  await page.locator(".handle-wind").focus();
  await studio.press("ArrowLeft");
  assert.notDeepEqual((await studio.kept()).hairstyle.motion.wind, before.hairstyle.motion.wind, "the wind is turned");
  const sheet = page.getByRole("slider", { name: "Exposure sheet" });
  const start = await sheet.getAttribute("aria-valuenow");
  await page.locator(".stage-canvas").focus();
  await studio.press(".");
  assert.notEqual(await sheet.getAttribute("aria-valuenow"), start, "the tooltips' keys step through the pictures");
  await studio.press(" ");
  await studio.button("Pause").waitFor();
  await studio.press(" ");
  await studio.button("Play").waitFor();
}
