import assert from "node:assert/strict";

/** Without the server the page says so and goes on: one draws, undoes and redoes. When it is back, the hair appears. */
export async function goesOnAlone({ open, server }) {
  const studio = await open();
  const { page } = studio;
  const away = page.locator(".stage-away");
  studio.watch.allow(/ERR_CONNECTION_REFUSED|ERR_CONNECTION_RESET|ERR_EMPTY_RESPONSE/);
  const bald = await studio.look();
  await studio.draw([-0.06, -0.2], [-0.1, -0.1], [-0.14, 0]);
  await server.stop();
  try {
    await studio.draw([0.02, -0.22], [0.02, -0.1], [0.02, 0]);
    await away.waitFor();
    assert.match(await away.textContent(), /does not answer/);
    assert.equal((await studio.tufts()).length, 2, "drawing goes on");
    await studio.press("Control+z", "Control+z");
    assert.equal((await studio.tufts()).length, 0);
    await page.mouse.move(0, 0);
    assert.equal((await studio.look()).hash, bald.hash);
    await studio.press("Control+y");
    assert.ok((await studio.look()).changed > 400, "what was meshed before is seen without the server");
    await studio.press("Control+y");
    assert.equal((await studio.tufts()).length, 2);
    await studio.look();
  } finally {
    await server.start();
  }
  await away.waitFor({ state: "hidden" });
  assert.ok((await studio.look()).changed > 400, "the hair that was missing appears");
}
