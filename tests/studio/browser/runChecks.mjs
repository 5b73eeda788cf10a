import { mkdir } from "node:fs/promises";
import { join } from "node:path";

/**
 * Runs checks one after the other, each with pages of its own, and prints a line for each. What the page looks like when a check
 * fails goes to `folder`.
 * @param checks  functions of { open, server, url, say }; `say` prints beneath the check's line
 * @return  how many failed
 */
export async function runChecks(checks, { browser, server, url, folder }) {
  let failed = 0;
  await mkdir(folder, { recursive: true });
  for (const check of checks) {
    const begin = Date.now();
    const said = [];
    const faults = [];
    try {
      await check({ open: (options) => browser.open(url(), options), server, url: url(), say: (line) => said.push(line) });
    } catch (error) {
      faults.push(error.stack);
      for (const [i, { page }] of browser.pages.entries()) {
        await page.screenshot({ path: join(folder, `failed-${check.name}-${i + 1}.png`), timeout: 10_000 }).catch(() => {});
      }
    }
    faults.push(...(await browser.closePages()));
    if (faults.length > 0) failed += 1;
    console.log(`${faults.length > 0 ? "FAIL" : "ok  "} ${check.name.padEnd(30)} ${((Date.now() - begin) / 1000).toFixed(1).padStart(5)} s`);
    for (const line of [...said, ...faults]) console.log(line.replace(/^/gm, "       "));
  }
  return failed;
}
