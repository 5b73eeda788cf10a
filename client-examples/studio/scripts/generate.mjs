// Makes src/api/generated from the contract: its types, and its schemas as data, from which the page takes every range.
//
//   npm run generate
import { mkdir, readFile, writeFile } from "node:fs/promises";
import openapiTS, { astToString } from "openapi-typescript";
import { parse } from "yaml";

const kContract = new URL("../../../api/openapi.yaml", import.meta.url);
const kOut = new URL("../src/api/generated/", import.meta.url);

/** Only where it is new, so that a running dev server does not reload for nothing. */
async function write(name, text) {
  const file = new URL(name, kOut);
  if ((await readFile(file, "utf8").catch(() => null)) !== text) await writeFile(file, text);
}

await mkdir(kOut, { recursive: true });
const contract = parse(await readFile(kContract, "utf8"));
await write("openapi.ts", astToString(await openapiTS(kContract, { defaultNonNullable: false })));
await write("schemas.json", `${JSON.stringify(contract.components.schemas)}\n`);
