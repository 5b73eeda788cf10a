import assert from "node:assert/strict";
import { hairstyle, twoTufts } from "../hairstyles.mjs";

const kEnglish = /[A-Za-z]{4,}/;
const kNames = /^(Tuftwave|English|left|right|test|Enter|Delete|Shift)$/;

/** Nothing scrolls sideways or is out of reach at 1280 and 768, in either language; the language is changed and kept, and no words are left behind. */
export async function fitsAndSpeaks({ open }) {
  for (const [width, height] of [[1280, 640], [768, 900]]) {
    const studio = await open({ width, height, kept: hairstyle(twoTufts()) });
    const { page } = studio;
    await studio.mode("Move");
    const stage = await page.locator(".stage-canvas").boundingBox();
    const [[windX]] = await studio.handles("wind");
    assert.ok(windX > stage.x && windX < stage.x + stage.width, `${width} px: the wind's arrow can be taken hold of`);
    for (const language of ["en", "ja"]) {
      assert.equal(await page.evaluate(() => document.documentElement.lang), language);
      for (const key of ["1", "2", "3", "4"]) {
        await studio.press(key);
        if (key === "2") await studio.row("left").click();
        const wide = await page.evaluate(() => [document.documentElement, document.body, ...document.querySelectorAll(".panel, .top-bar, .timeline, .mode-bar, main")]
          .filter((one) => one.scrollWidth > one.clientWidth + 1 && one.checkVisibility()).map((one) => `${one.className || one.tagName} ${one.scrollWidth} > ${one.clientWidth}`));
        assert.deepEqual(wide, [], `${width} px, ${language}, mode ${key}`);
        if (language === "ja") {
          const words = (await page.locator("#studio, .app").innerText()).split(/[^A-Za-z]+/).filter((word) => kEnglish.test(word) && !kNames.test(word));
          assert.deepEqual(words, [], `English words in Japanese, mode ${key}`);
        }
      }
      if (language === "en") await page.getByRole("button", { name: "日本語" }).click();
    }
    await page.reload();
    await studio.ready();
    assert.equal(await page.evaluate(() => document.documentElement.lang), "ja", "the language is kept");
    await page.getByRole("button", { name: "English" }).click();
    await page.getByText("Tools").or(studio.button("Undo")).first().waitFor();
    await page.context().close();
  }
}
