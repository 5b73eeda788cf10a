// Makes docs/images from a running service: TUFTWAVE_URL=http://127.0.0.1:8080 node render.mjs [picture...]
import { mkdir, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";

import { openBrowser } from "./browser.mjs";
import { takeHero } from "./hero.mjs";
import { openPainter } from "./painter.mjs";
import { encode } from "./png.mjs";

const kFolder = fileURLToPath(new URL("../../docs/images/", import.meta.url));
const kColors = { hero: 128, heads: 256, ponytail: 256, tufts: 256, steps: 256, fills: 256, six: 256, uploads: 256 };

async function write(name, taken) {
  const { file, width, height } = encode(taken, kColors[name]);
  await writeFile(`${kFolder}${name}.png`, file);
  console.log(`docs/images/${name}.png ${width}x${height}, ${taken.frames.length} pictures, ${Math.ceil(file.length / 1000)} kB`);
}

const url = process.env.TUFTWAVE_URL ?? "http://127.0.0.1:8080";
const wanted = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(kColors);
const browser = await openBrowser();
try {
  await mkdir(kFolder, { recursive: true });
  if (wanted.includes("hero")) await write("hero", await takeHero(browser, url));
  const painted = wanted.filter((name) => name !== "hero");
  if (painted.length > 0) {
    const { draw, close } = await openPainter(browser, url);
    for (const name of painted) await write(name, await draw(name));
    await close();
  }
} finally {
  await browser.close();
}
