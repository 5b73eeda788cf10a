import assert from "node:assert/strict";

const kRoot = [-0.05, -0.2];
const kNext = [[-0.14, -0.14], [-0.2, 0]];

async function clickAll(studio, places) {
  for (const [x, y] of places) {
    await studio.click(x, y);
    await studio.page.mouse.move(...(await studio.at(x + 0.03, y)));
  }
}

/** Clicked, a lock goes on point by point on a plane through its root, which is turned by its handle and by keys. */
export async function drawsPointByPoint({ open }) {
  const studio = await open();
  await clickAll(studio, [kRoot, ...kNext]);
  await studio.press("Enter");
  const [flat] = await studio.tufts();
  assert.equal(flat.points.length, 3);

  await clickAll(studio, [kRoot]);
  const [handle] = await studio.handles("plane");
  await studio.pointer.mouse([handle, [handle[0] + 60, handle[1] + 20]]);
  const [turned] = await studio.handles("plane");
  assert.ok(Math.abs(turned[0] - handle[0]) > 20, "the plane's handle follows the pointer");
  await clickAll(studio, kNext);
  await studio.press("Enter");
  const [, other] = await studio.tufts();
  assert.deepEqual(other.points[0], flat.points[0], "both have the same root");
  const away = Math.hypot(...other.points[1].map((x, axis) => x - flat.points[1][axis]));
  assert.ok(away > 0.005, `on another plane the same click is another place, ${away} m away`);

  await clickAll(studio, [kRoot]);
  await studio.press("Shift+ArrowLeft", "Shift+ArrowLeft");
  await clickAll(studio, kNext);
  await studio.press("Backspace", "Enter");
  const [, , third] = await studio.tufts();
  assert.equal(third.points.length, 2, "Backspace takes the last point back");
  assert.notDeepEqual(third.points[1], flat.points[1], "keys turn the plane as well");

  await clickAll(studio, [kRoot, ...kNext]);
  await studio.press("Escape");
  assert.equal((await studio.tufts()).length, 3, "Esc gives up");
  assert.equal((await studio.handles("plane")).length, 0);
}
