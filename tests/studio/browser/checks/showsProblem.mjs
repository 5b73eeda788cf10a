import assert from "node:assert/strict";
import { hairstyle, twoTufts } from "../hairstyles.mjs";

/** What the service refuses is said in its own words at the field, and everything can go on. */
export async function showsProblem({ open }) {
  const studio = await open({ kept: hairstyle(twoTufts()) });
  studio.watch.allow(/status of 422/);
  await studio.mode("Shape");
  await studio.row("left").click();
  await studio.type("Thickness", 500);
  const problem = studio.page.locator('[data-field="/tufts/diameter"] .field-problem');
  await problem.waitFor();
  assert.match(await problem.textContent(), /100/, "it says what is allowed");
  assert.equal(await studio.number("Thickness").getAttribute("aria-invalid"), "true");
  assert.equal(await studio.page.locator(".stage-problem").isVisible(), false, "said once, where one looks");

  await studio.type("Widest at", 20);
  assert.equal((await studio.tufts())[0].widest_at, 20, "the document can be edited on");
  await studio.type("Thickness", 50);
  await problem.waitFor({ state: "hidden" });

  await studio.mode("Draw");
  await studio.type("Twist", 1e9);
  await studio.draw([0.02, -0.22], [0, -0.1], [0, 0]);
  await studio.page.locator('[data-field="/tufts/twist_deg"] .field-problem').waitFor();
  await studio.press("Control+z");
  await studio.settle();
  assert.equal(await studio.page.locator(".field-problem:visible").count(), 0, "undone, all is well again");
}
