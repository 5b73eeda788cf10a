import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { hairstyle, twoTufts, wholeHead } from "../hairstyles.mjs";

const kData = fileURLToPath(new URL("../../../data/", import.meta.url));
const kHead = `${kData}heads/mpfb_head_base.glb`;
const kCharacter = `${kData}characters/godette.vrm1.vrm`;

const fileOf = (name, content) => ({ name, mimeType: "application/octet-stream", buffer: Buffer.from(content) });

/** Drops a file onto the page. */
async function drop(page, { name, buffer }) {
  await page.evaluate(([name, base64]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
    for (const type of ["dragover", "drop"]) document.querySelector(".stage-canvas").dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
  }, [name, buffer.toString("base64")]);
}

/** Hairstyles, heads and characters are opened by button and by drop; what is no such file is said, and nothing is lost. */
export async function opensFiles({ open }) {
  const studio = await open({ kept: hairstyle(twoTufts()) });
  const { page } = studio;
  const notice = page.locator(".bring-notice");
  const choose = async (file) => {
    await page.locator("input.open-file").setInputFiles(file);
    await studio.settle();
  };
  const before = await studio.kept();
  const brought = hairstyle(wholeHead(5)).hairstyle;
  await studio.look();
  await choose(fileOf("five.json", JSON.stringify(brought)));
  assert.deepEqual((await studio.tufts()).map(({ points }) => points), brought.tufts.map(({ points }) => points));
  assert.equal((await studio.kept()).name, "five");
  assert.ok((await studio.look()).changed > 400);
  await studio.press("Control+z");
  assert.deepEqual(await studio.kept(), before, "opening is one step");

  await drop(page, fileOf("dropped.json", JSON.stringify(brought)));
  await studio.settle();
  assert.equal((await studio.kept()).name, "dropped");

  await choose(fileOf("letter.txt", "Dear hair,"));
  await notice.waitFor();
  assert.match(await notice.textContent(), /letter\.txt/);
  assert.equal((await studio.kept()).name, "dropped", "nothing is lost");

  await choose(fileOf("wrong.json", JSON.stringify({ ...brought, tufts: [{ ...brought.tufts[0], diameter: 500 }] })));
  studio.watch.allow(/status of 4\d\d/);
  assert.match(await notice.textContent(), /\/tufts\/0\/diameter/, "it names the field");
  assert.equal((await studio.kept()).name, "dropped");

  await studio.look();
  await choose(kHead);
  await page.getByText("Head: mpfb_head_base.glb").waitFor();
  assert.ok((await studio.look()).changed > 400, "the head is seen");

  await choose(kCharacter);
  await studio.mode("Move");
  await page.getByText("Character: godette.vrm1.vrm").waitFor();
  await page.getByRole("slider", { name: "Exposure sheet" }).focus();
  await studio.press("Home");
  const first = await studio.look();
  await studio.press("ArrowUp", "ArrowUp");
  assert.notEqual((await studio.look()).hash, first.hash, "its hair moves");
  await page.getByRole("button", { name: "Take the file with its clip" }).scrollIntoViewIfNeeded();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Take the file with its clip" }).click()]);
  assert.equal((await readFile(await download.path())).subarray(0, 4).toString(), "glTF");
}
