import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import { stateGroups } from "./states.mjs";

const kSizes = [[1280, 800], [768, 1024]];
const kSchemes = ["light", "dark"];
const kLocales = [["en", "en-US"], ["ja", "ja-JP"]];

/** Writes a picture of every state, in each size, light and dark, in each language: STATE-WIDTH-SCHEME-LANGUAGE.png. @param only  part of the names */
export async function takeScreenshots({ browser, server, url, folder, only }) {
  await mkdir(folder, { recursive: true });
  for (const [width, height] of kSizes) for (const colorScheme of kSchemes) for (const [language, locale] of kLocales) for (const { kept, states } of stateGroups) {
    const names = states.map(({ name }) => `${name}-${width}-${colorScheme}-${language}`);
    const last = names.findLastIndex((name) => name.includes(only));
    if (last < 0) continue;
    const studio = await browser.open(url(), { width, height, colorScheme, locale, kept, antialias: true });
    for (const [i, { show, leave }] of states.slice(0, last + 1).entries()) {
      await show(studio, server);
      await studio.settle();
      if (names[i].includes(only)) await studio.page.screenshot({ path: join(folder, `${names[i]}.png`) });
      await leave?.(studio, server);
    }
    for (const fault of await browser.closePages()) console.log(`${width} ${colorScheme} ${language}: ${fault}`);
  }
}
