import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { hairstyle, twoTufts } from "../hairstyles.mjs";

const kAxe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const kLooks = [{ colorScheme: "light", locale: "en-US" }, { colorScheme: "dark", locale: "ja-JP" }]; // contrast goes by colors, not by words

async function faultsOf({ page }) {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(kAxe);
  const { violations } = await page.evaluate(() => window.axe.run());
  return violations.filter(({ impact }) => impact === "serious" || impact === "critical")
    .map(({ id, help, nodes }) => `${id}: ${help}\n${nodes.slice(0, 4).map(({ html }) => `    ${html.slice(0, 160)}`).join("\n")}`);
}

/** axe finds nothing serious in any mode or dialog, light and dark, in English and Japanese. */
export async function isAccessible({ open }) {
  const faults = [];
  for (const look of kLooks) {
    const studio = await open({ width: 1024, height: 720, ...look, kept: hairstyle(twoTufts()) });
    const note = async (state) => faults.push(...(await faultsOf(studio)).map((fault) => `${look.colorScheme} ${look.locale} ${state}: ${fault}`));
    for (const [key, state] of [["1", "Draw"], ["3", "Fill"], ["4", "Move"], ["2", "Shape"]]) {
      await studio.press(key);
      if (state === "Shape") await studio.row("left").click();
      await studio.settle();
      await note(state);
    }
    for (const key of ["?", "Control+s"]) {
      await studio.press(key);
      await studio.page.getByRole("dialog").waitFor();
      await studio.settle();
      await note(`dialog of ${key}`);
      await studio.press("Escape");
    }
    await studio.page.getByRole("button", { name: /^(Gallery|ギャラリー)$/ }).click();
    await studio.page.getByRole("dialog").waitFor();
    await studio.settle();
    await note("gallery");
    await studio.page.context().close();
  }
  assert.deepEqual(faults, []);
}
