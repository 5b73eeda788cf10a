// The page that paints the pictures of hair.
import { extname } from "node:path";
import { newPage } from "./browser.mjs";
import { hairFrom } from "./service.mjs";
import { servePage } from "./studio.mjs";

const kTypes = { ".json": "application/json", ".glb": "model/gltf-binary" };

/** Answers /hair/NAME.json and /hair/NAME.glb. */
function answerFrom(hair) {
  return async (route) => {
    const name = new URL(route.request().url()).pathname.slice("/hair/".length);
    try {
      await route.fulfill({ contentType: kTypes[extname(name)], body: await hair(name) });
    } catch (error) {
      await route.fulfill({ status: 500, contentType: "text/plain", body: String(error) });
    }
  };
}

/** @param url  of the service; @return  draw(name), to its frames: png (a Buffer) and hold each, and fps; close() */
export async function openPainter(browser, url) {
  const server = await servePage();
  const page = await newPage(browser);
  await page.route("**/hair/*", answerFrom(hairFrom(url)));
  await page.goto(`${server.url}page.html`);
  await page.waitForFunction(() => "drawPicture" in window);
  const draw = async (name) => {
    const { frames, fps } = await page.evaluate((wanted) => window.drawPicture(wanted), name);
    return { frames: frames.map(({ png, hold }) => ({ png: Buffer.from(png.split(",")[1], "base64"), hold })), fps };
  };
  const close = async () => {
    await page.close();
    await server.close();
  };
  return { draw, close };
}
