import assert from "node:assert/strict";

/** After a bit of everything, undo leads step by step back to the empty head, and redo through the same documents to the end. */
export async function undoesEverything({ open }) {
  const studio = await open();
  const { page } = studio;
  const documents = [await studio.kept()];
  const step = async (act) => {
    await act();
    await studio.settle();
    documents.push(await studio.kept());
    assert.notDeepEqual(documents.at(-1), documents.at(-2), `step ${documents.length - 1} changes something`);
  };
  await step(() => studio.draw([-0.06, -0.2], [-0.1, -0.1], [-0.14, 0]));
  await page.getByRole("checkbox", { name: "Draw both sides" }).check();
  await step(() => studio.draw([0, -0.22], [0.02, -0.12], [0.02, 0]));
  await studio.mode("Shape");
  await studio.row("tuft").click();
  await step(() => studio.type("Widest at", 70));
  await step(() => page.getByRole("radio", { name: "Round" }).first().check({ force: true }));
  await step(() => studio.press("Control+d"));
  await step(() => studio.button("Erase").click());
  await studio.mode("Move");
  await step(() => studio.type("Amplitude", 0.5));
  await step(() => page.getByRole("radio", { name: "Threes" }).check({ force: true }));
  await step(async () => {
    const [wind] = await studio.handles("wind");
    await studio.pointer.mouse([wind, [wind[0] - 30, wind[1] + 15], [wind[0] - 50, wind[1] + 15]]);
  });
  await studio.mode("Draw");
  await step(() => studio.page.getByRole("button", { name: "Hair color #" }).last().click());

  for (const expected of documents.slice(0, -1).reverse()) {
    await studio.button("Undo").click();
    assert.deepEqual(await studio.kept(), expected);
  }
  assert.equal(await studio.button("Undo").isDisabled(), true);
  for (const expected of documents.slice(1)) {
    await studio.press("Control+Shift+Z");
    assert.deepEqual(await studio.kept(), expected);
  }
  assert.equal(await studio.button("Redo").isDisabled(), true);
}
