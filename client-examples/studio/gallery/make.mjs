// Draws the hairstyles of the gallery in the page, as a person would, and keeps what the page keeps and a small picture of each.
//
//   npm run gallery [names]       needs a service (TUFTWAVE_URL, else http://127.0.0.1:8080), Debian's chromium (CHROMIUM, else
//                                 /usr/bin/chromium) and `npm ci` in tests/studio
import { readdir, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { fileURLToPath } from "node:url";
import { createServer } from "vite";
import { Artist } from "./Artist.mjs";

const { chromium } = createRequire(new URL("../../../tests/studio/package.json", import.meta.url))("playwright-core");
const kPicture = { width: 240, height: 280, most_bytes: 20_000 };
const kPace_ms = 900; // between pictures while strokes are drawn: a browser without a graphics card takes long over each

const here = new URL("./", import.meta.url);
const known = (await readdir(new URL("recipes/", here))).map((file) => file.replace(/\.mjs$/, ""));
const names = process.argv.length > 2 ? process.argv.slice(2) : known;

/** Lets the page show fewer pictures while somebody draws; 0 as many as it likes. */
function slowFrames(pace_ms) {
  globalThis.pace_ms = pace_ms;
  const own = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.requestAnimationFrame = (act) => (globalThis.pace_ms > 0 ? setTimeout(() => act(performance.now()), globalThis.pace_ms) : own(act));
}

/** The hair alone with its head, transparent, as WebP in base64. */
async function picture(page, artist, view, isNear) {
  await page.evaluate(() => (globalThis.pace_ms = 0));
  await artist.mode("shape");
  await artist.look(view);
  if (isNear) await page.locator(".stage-canvas").press("+");
  await page.addStyleTag({ content: "*{background:none!important} body *{visibility:hidden!important} .stage-canvas{visibility:visible!important;outline:none!important}" });
  await page.waitForTimeout(1500);
  const { x, y, width, height } = await page.locator(".stage-canvas").boundingBox();
  const shown = Math.min(width, (height * kPicture.width) / kPicture.height);
  const png = await page.screenshot({ omitBackground: true, clip: { x: x + (width - shown) / 2, y, width: shown, height } });
  return page.evaluate(async ({ data, width, height }) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob(), { resizeWidth: width, resizeHeight: height, resizeQuality: "high" });
    const canvas = Object.assign(document.createElement("canvas"), { width, height });
    canvas.getContext("2d").drawImage(image, 0, 0);
    return canvas.toDataURL("image/webp", 0.86).split(",")[1];
  }, { data: png.toString("base64"), ...kPicture });
}

async function make(browser, url, name) {
  const { steps, view = "quarter", isNear = true } = await import(new URL(`recipes/${name}.mjs`, here));
  const page = await browser.newPage({ viewport: { width: 900, height: 620 }, locale: "en-US" });
  page.setDefaultTimeout(20_000);
  await page.addInitScript(slowFrames, kPace_ms);
  await page.goto(url);
  await page.locator(".stage-canvas").waitFor();
  const artist = new Artist(page);
  await artist.start();
  for (const step of steps) await step(artist);
  await artist.rename();
  const { hairstyle } = await artist.kept();
  await writeFile(new URL(`${name}.json`, here), `${JSON.stringify(hairstyle)}\n`);
  const webp = Buffer.from(await picture(page, artist, view, isNear), "base64");
  if (webp.length > kPicture.most_bytes) throw new Error(`${name}: a picture of ${webp.length} bytes`);
  await writeFile(new URL(`${name}.webp`, here), webp);
  await page.close();
  console.log(`${name}: ${hairstyle.tufts.length} tufts, a picture of ${webp.length} bytes`);
}

const vite = await createServer({ root: fileURLToPath(new URL("../", here)), server: { host: "127.0.0.1", port: 0, hmr: false, watch: null }, logLevel: "error" });
await vite.listen();
const url = `http://127.0.0.1:${vite.httpServer.address().port}/studio/`;
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--enable-unsafe-swiftshader", "--force-color-profile=srgb"],
});
try {
  for (const name of names) await make(browser, url, name);
} finally {
  await browser.close();
  await vite.close();
}
