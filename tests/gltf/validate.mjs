// Validates every .glb and .gltf of a directory with Khronos' validator.
//
//   node validate.mjs DIRECTORY
//
// No errors, no warnings, and of the infos only those of ALLOWED. Exit code 0 or 1.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

import validator from "gltf-validator";

import { Checks } from "./checks.mjs";

const PACKING = "EXT_meshopt_compression";
const isPacked = (json) => json.extensionsUsed?.includes(PACKING) ?? false;

// What the validator remarks on although it is meant: texture coordinates without a texture, which are for the user's
// own one, tips of chains, which are nodes that carry nothing, and packed views, of which it knows nothing.
const ALLOWED = {
  UNUSED_OBJECT: (pointer, json) => /^\/meshes\/\d+\/primitives\/0\/attributes\/TEXCOORD_0$/.test(pointer) || (isPacked(json) && pointer === "/buffers/0"),
  UNSUPPORTED_EXTENSION: (pointer, json) => isPacked(json) && pointer === `/extensionsUsed/${json.extensionsUsed.indexOf(PACKING)}`,
  NODE_EMPTY: (pointer, json) => {
    const index = Number(pointer.split("/")[2]);
    const isJoint = (json.skins ?? []).some((skin) => skin.joints.includes(index));
    return !isJoint && json.nodes.some((node) => node.children?.includes(index)) && /_\d\d$/.test(json.nodes[index].name);
  },
};

function jsonOf(bytes) {
  const isBinary = bytes.readUInt32LE(0) === 0x46546c67;
  return JSON.parse(isBinary ? bytes.subarray(20, 20 + bytes.readUInt32LE(12)) : bytes);
}

function faultOf(report, json) {
  const bad = report.issues.messages.filter(({ severity, code, pointer }) => severity < 2 || (severity === 2 && !ALLOWED[code]?.(pointer, json)));
  if (report.issues.truncated) return "more issues than the validator lists";
  return bad.length === 0 ? "" : `${bad.length} issues, the first ${bad[0].code} at ${bad[0].pointer}: ${bad[0].message}`;
}

const [directory] = process.argv.slice(2);
const checks = new Checks();
const infos = new Map();
const totals = { errors: 0, warnings: 0, infos: 0, hints: 0, vertices: 0, triangles: 0 };
for (const name of readdirSync(directory).filter((file) => /\.(glb|gltf)$/.test(file)).sort()) {
  const bytes = readFileSync(join(directory, name));
  try {
    const report = await validator.validateBytes(new Uint8Array(bytes), { uri: name, maxIssues: 0, writeTimestamp: false });
    checks.add(name, faultOf(report, jsonOf(bytes)));
    totals.errors += report.issues.numErrors;
    totals.warnings += report.issues.numWarnings;
    totals.infos += report.issues.numInfos;
    totals.hints += report.issues.numHints;
    totals.vertices += report.info.totalVertexCount;
    totals.triangles += report.info.totalTriangleCount;
    for (const { code } of report.issues.messages) infos.set(code, (infos.get(code) ?? 0) + 1);
  } catch (error) {
    checks.add(name, String(error));
  }
}
console.log(`glTF validator ${validator.version()}: ${Object.entries(totals).map(([what, count]) => `${count} ${what}`).join(", ")}`);
for (const [code, count] of [...infos].sort()) console.log(`  ${code}: ${count}`);
checks.finish();
