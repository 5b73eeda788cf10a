// The studio in a real browser, served by a real server:
//   npm run -s browser -- --server PATH [--only NAME] [--page URL] [--screenshots]
// --only runs the checks whose names have NAME in them. --page tries the page of another address, such as vite's, in place of the
// server's own. --screenshots writes a picture of every state of the page to tests/studio/out/, for people to look at, and tries nothing.
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { Browser } from "./browser/Browser.mjs";
import { checks } from "./browser/checks.mjs";
import { runChecks } from "./browser/runChecks.mjs";
import { Server } from "./browser/Server.mjs";
import { takeScreenshots } from "./browser/takeScreenshots.mjs";

const kFolder = fileURLToPath(new URL("out/", import.meta.url));

const { values } = parseArgs({
  options: { server: { type: "string" }, only: { type: "string", default: "" }, page: { type: "string" }, screenshots: { type: "boolean", default: false } },
});
if (!values.server) {
  console.error("usage: check_studio.mjs --server PATH [--only NAME] [--page URL] [--screenshots]");
  process.exit(2);
}

const server = new Server(values.server);
const begin = Date.now();
let failed = 0;
try {
  await server.start();
  const url = () => values.page ?? `${server.origin}/`;
  const browser = await Browser.launch();
  try {
    if (values.screenshots) await takeScreenshots({ browser, server, url, folder: kFolder, only: values.only });
    else failed = await runChecks(checks.filter(({ name }) => name.toLowerCase().includes(values.only.toLowerCase())), { browser, server, url, folder: kFolder });
  } finally {
    await browser.close();
  }
} finally {
  await server.stop();
}
console.log(`${failed === 0 ? "passed" : `${failed} failed`} in ${((Date.now() - begin) / 1000).toFixed(0)} s`);
process.exitCode = failed === 0 ? 0 : 1;
