// Makes docs/images from a running service: TUFTWAVE_URL=http://127.0.0.1:8080 node render.mjs [picture...]
import { mkdir, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";

import { openPage } from "./browser.mjs";
import { encode } from "./png.mjs";
import { hairFrom } from "./service.mjs";

const kFolder = fileURLToPath(new URL("../../docs/images/", import.meta.url));
const kColors = { hero: 128, heads: 256, ponytail: 256, tufts: 256, steps: 256, fills: 256, six: 256, uploads: 256 };

async function render(page, name) {
  const { frames, fps } = await page.evaluate((wanted) => window.drawPicture(wanted), name);
  const pngs = frames.map(({ png, hold }) => ({ png: Buffer.from(png.split(",")[1], "base64"), hold }));
  const { file, width, height } = encode(pngs, fps, kColors[name]);
  await writeFile(`${kFolder}${name}.png`, file);
  console.log(`docs/images/${name}.png ${width}x${height}, ${frames.length} pictures, ${Math.ceil(file.length / 1000)} kB`);
}

const url = process.env.TUFTWAVE_URL ?? "http://127.0.0.1:8080";
const wanted = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(kColors);
const { page, close } = await openPage(hairFrom(url));
try {
  await mkdir(kFolder, { recursive: true });
  for (const name of wanted) await render(page, name);
} finally {
  await close();
}
