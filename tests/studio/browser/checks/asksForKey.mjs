import assert from "node:assert/strict";
import { mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";

/** Where the server wants a key the page asks for one, again while it is refused, and keeps it for the tab alone. */
export async function asksForKey({ open, server }) {
  const folder = await mkdtemp(join(tmpdir(), "studio-"));
  try {
    const { key, line } = await server.newKey("visitor");
    await writeFile(join(folder, "keys"), line, { mode: 0o600 });
    await server.stop();
    await server.start("--key-file", join(folder, "keys"));
    const studio = await open();
    const { page } = studio;
    studio.watch.allow(/401/);
    const dialog = page.getByRole("dialog", { name: "A key, please" });
    const answer = async (text) => {
      await dialog.getByLabel("Key", { exact: true }).fill(text);
      await page.keyboard.press("Enter");
    };
    await studio.draw([-0.06, -0.2], [-0.1, -0.1], [-0.14, 0]);
    await dialog.waitFor();
    assert.ok(await dialog.getByLabel("Key", { exact: true }).evaluate((field) => field === document.activeElement), "one types at once");
    await answer("too short");
    assert.match(await dialog.getByRole("alert").textContent(), /20 to 200/);
    await answer("a-key-that-is-not-known-here");
    await dialog.getByText("did not accept").waitFor();
    await answer(key);
    await dialog.waitFor({ state: "hidden" });
    assert.ok((await studio.look()).changed > 400, "the hair appears");
    assert.ok(!(await page.evaluate(() => JSON.stringify({ ...localStorage }))).includes(key), "it is kept for the tab alone");
    await page.reload();
    await studio.ready();
    assert.ok((await studio.look()).changed > 400, "the hair is back without a question");
    assert.equal(await dialog.count(), 0);
  } finally {
    await server.stop();
    await server.start();
    await rm(folder, { recursive: true });
  }
}
