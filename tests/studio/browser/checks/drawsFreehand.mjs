import assert from "node:assert/strict";

const kLock = [[-0.06, -0.2], [-0.1, -0.12], [-0.14, -0.02]];
const kSeen = 400; // pixels at least; a lock covers some thousands

/** Pressed on the head and drawn, there is one lock more in the document and on the screen: by mouse, pen and finger. */
export async function drawsFreehand({ open }) {
  const studio = await open({ hasTouch: true });
  await studio.look();
  await studio.draw(...kLock);
  const { changed } = await studio.look();
  assert.equal((await studio.tufts()).length, 1, "a stroke by mouse is one tuft");
  assert.ok(changed > kSeen, `hair is seen: ${changed} pixels changed`);

  const places = await studio.line(...kLock.map(([x, y]) => [x + 0.12, y]));
  await studio.pointer.pen(places, 0.15);
  await studio.pointer.pen(places, 0.95);
  await studio.pointer.pen(places, (part) => 0.2 + 0.7 * part);
  const [mouse, light, heavy, growing] = await studio.tufts();
  assert.ok(light.diameter < mouse.diameter && mouse.diameter < heavy.diameter, `${light.diameter} < ${mouse.diameter} < ${heavy.diameter}`);
  assert.ok(growing.widest_at > 60, `pressed hardest at its end, a lock is widest there: ${growing.widest_at}`);

  await studio.look();
  await studio.pointer.finger(await studio.line([0.02, -0.22], [0.0, -0.12], [0.0, 0]));
  assert.ok((await studio.look()).changed > kSeen);
  assert.equal((await studio.tufts()).length, 5, "a stroke by finger is one tuft");
}
