// Headless Chromium with one page, whose every request is answered from here.
import { readFile } from "node:fs/promises";
import { extname } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const kOrigin = "http://pictures.invalid";
const kHere = fileURLToPath(new URL(".", import.meta.url));
const kData = fileURLToPath(new URL("../data/", import.meta.url));
const kTypes = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".glb": "model/gltf-binary",
};
const kArguments = [
  "--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", "--force-color-profile=srgb", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
];

function answerFrom(hair) {
  return async (route) => {
    const path = new URL(route.request().url()).pathname;
    try {
      const body = path.startsWith("/hair/") ? await hair(path.slice("/hair/".length))
        : await readFile(path.startsWith("/heads/") ? kData + path.slice(1) : kHere + path.slice(1));
      await route.fulfill({ contentType: kTypes[extname(path)] ?? "application/octet-stream", body });
    } catch (error) {
      await route.fulfill({ status: error.code === "ENOENT" ? 404 : 500, contentType: "text/plain", body: String(error) });
    }
  };
}

/** @param hair  answers "NAME.glb" and "NAME.json" with a Buffer */
export async function openPage(hair) {
  const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: kArguments });
  const page = await browser.newPage();
  page.on("console", (message) => message.type() === "error" && console.error(`page: ${message.text()}`));
  page.on("pageerror", (error) => console.error(`page: ${error.stack}`));
  await page.route("**/*", answerFrom(hair));
  await page.goto(`${kOrigin}/page.html`);
  await page.waitForFunction(() => "drawPicture" in window);
  return { page, close: () => browser.close() };
}
