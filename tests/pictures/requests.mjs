// The bodies that are posted: made by the converters from the test data, or written out in shapes.mjs and fills.mjs.
import { execFile } from "node:child_process";
import { readdir } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

import { kFills } from "./fills.mjs";
import { kShapes } from "./shapes.mjs";

const run = promisify(execFile);
const path = (relative) => fileURLToPath(new URL(`../../${relative}`, import.meta.url));

const kStrand = "0.0065"; // metres: thicker than the gap between them, so that the tail has no holes
const kStrokes = { vita: "Vita", shibu: "Sendagaya_Shibu", fumiriya: "Sakurada_Fumiriya" };

async function convert(script, files, motion, more = []) {
  const options = [path(`client-examples/pipeline/${script}`), ...files, ...more, "--motion", motion, "--out", "-"];
  return (await run("python3", options, { maxBuffer: 2 ** 26 })).stdout;
}

/** The JSON of a request, as text: a name from shapes.mjs or fills.mjs, or whose hair and in which motion, "vita-breeze". */
export async function requestNamed(name) {
  const written = kShapes[name] ?? kFills[name];
  if (written) return JSON.stringify(written);
  const [whose, motion] = name.split("-");
  if (whose in kStrokes) return convert("strokes_to_hairstyle.py", [path(`tests/data/strokes/vroid_${kStrokes[whose]}.strokes.json`)], motion);
  if (whose !== "ponytail") throw new Error(`no request is called ${name}`);
  const strands = (await readdir(path("tests/data/strands"))).filter((file) => file.endsWith(".tfx")).sort();
  return convert("strands_to_hairstyle.py", strands.map((file) => path(`tests/data/strands/${file}`)), motion, ["--diameter", kStrand]);
}
