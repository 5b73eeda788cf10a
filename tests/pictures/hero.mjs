// hero.png: one cycle of a hairstyle in the studio, as an artist sees it there.
import { readFile } from "node:fs/promises";

import { newPage } from "./browser.mjs";
import { serveStudio } from "./studio.mjs";

const kHairstyle = { file: "twintails.json", name: "Twin tails" }; // of the studio's gallery
const kGallery = new URL("../../client-examples/studio/gallery/", import.meta.url);
const kWindow = { width: 1280, height: 800 };
const kSamples = 2; // a side of each pixel
const kScale = 0.75; // pixels of the picture for one of the page

/** Opens the studio in Move and waits for its hair. @return  the page and the schedule of the cycle */
async function openMove(browser, address, kept) {
  const page = await newPage(browser, { viewport: kWindow, deviceScaleFactor: kSamples * kScale, locale: "en-US", colorScheme: "light", reducedMotion: "reduce" });
  await page.addInitScript((document) => localStorage.setItem("tuftwave.document", JSON.stringify(document)), kept);
  await page.goto(address);
  await page.locator(".stage-canvas").waitFor();
  const answer = page.waitForResponse(/\/v1\/hairstyles/);
  await page.getByRole("button", { name: "Move" }).click();
  const { schedule } = await (await answer).json();
  await page.mouse.move(0, 0);
  await page.evaluate(() => document.activeElement.blur()); // no ring around what was pressed
  await page.waitForLoadState("networkidle");
  return { page, schedule };
}

/** @param url  of the service; @return  frames, fps and samples; see encode */
export async function takeHero(browser, url) {
  const server = await serveStudio(url);
  const hairstyle = JSON.parse(await readFile(new URL(kHairstyle.file, kGallery)));
  const { page, schedule } = await openMove(browser, server.url, { name: kHairstyle.name, hairstyle });
  const frames = [];
  for (const hold of schedule.holds) {
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))); // until it is drawn
    frames.push({ png: await page.screenshot(), hold });
    await page.keyboard.press("."); // the next picture
  }
  await page.close();
  await server.close();
  return { frames, fps: schedule.fps, samples: kSamples };
}
