import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { readFile } from "node:fs/promises";
import { strFromU8, unzipSync } from "fflate";
import validator from "gltf-validator";
import { hairstyle, twoTufts } from "../hairstyles.mjs";

const kTiming = { period: 11 / 24, fps: 24, hold: 2 };
const kPngStart = "89504e470d0a1a0a";

/** Presses a button of the dialog and reads what is downloaded. */
async function take(studio, button) {
  const [download] = await Promise.all([studio.page.waitForEvent("download", { timeout: 60_000 }), studio.page.getByRole("dialog").getByRole("button", { name: button }).click()]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

/** Which picture begins at which frame, both from 0, as the XDTS says: its cells are numbered from 1. */
function startsOf(xdts) {
  const [first, ...rest] = xdts.split("\n");
  assert.equal(first, "exchangeDigitalTimeSheet Save Data");
  const [table] = JSON.parse(rest.join("\n")).timeTables;
  const [track] = table.fields.find(({ fieldId }) => fieldId === 0).tracks;
  return track.frames.filter(({ data }) => data[0].values[0] !== "SYMBOL_NULL_CELL").map(({ frame, data }) => [frame, Number(data[0].values[0]) - 1]);
}

/** The hairstyle, a GLB without fault, and a zip of pictures with an XDTS and a CSV that name them. */
export async function takesAway({ open, say }) {
  const studio = await open({ kept: hairstyle(twoTufts(), kTiming) });
  const answer = await studio.page.request.post(new URL("/v1/schedules", studio.page.url()).href, { data: { timing: kTiming } });
  const { schedule } = await answer.json();
  await studio.button("Take away").click();

  const json = await take(studio, "Hairstyle (JSON)");
  assert.equal(json.name, "test.json");
  assert.deepEqual(JSON.parse(json.bytes).tufts, await studio.tufts());

  const glb = await take(studio, "Model (GLB)");
  assert.equal(glb.name, "test.glb");
  const { issues, info } = await validator.validateBytes(new Uint8Array(glb.bytes));
  assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues.messages.slice(0, 5)));
  say(`GLB: ${info.totalVertexCount} vertices, ${info.animationCount} animation, valid`);

  for (const size of ["Width", "Height"]) await studio.page.getByRole("spinbutton", { name: size }).fill("512");
  const zip = await take(studio, "Take the pictures (ZIP)");
  const files = unzipSync(new Uint8Array(zip.bytes));
  const names = Object.keys(files).map((name) => name.replace(/^test\//, ""));
  const pictures = names.filter((name) => name.endsWith(".png")).sort();
  assert.equal(pictures.length, schedule.pictures);
  for (const name of pictures) assert.equal(Buffer.from(files[`test/${name}`].subarray(0, 8)).toString("hex"), kPngStart, name);
  const hashes = pictures.map((name) => createHash("sha256").update(files[`test/${name}`]).digest("hex"));
  assert.equal(new Set(hashes).size, schedule.pictures, "no two pictures are the same");

  assert.deepEqual(startsOf(strFromU8(files["test/test.xdts"])), schedule.starts.map((start, picture) => [start, picture]));
  const rows = strFromU8(files["test/test.csv"]).trim().split(/\r?\n/).slice(1).map((row) => row.split(","));
  const shown = schedule.holds.flatMap((hold, picture) => Array(hold).fill(pictures[picture]));
  assert.deepEqual(rows.map((row) => row.at(-1)), shown, "the CSV names a picture at each frame");
  assert.equal(names.includes("README.txt"), true);
  say(`ZIP: ${pictures[0]} to ${pictures.at(-1)}, ${Math.round(zip.bytes.length / 1024)} kB`);

  await studio.press("Escape");
  await studio.page.getByRole("dialog").waitFor({ state: "detached" });
  assert.equal(await studio.button("Take away").evaluate((button) => button === document.activeElement), true, "the focus returns");
}
