import assert from "node:assert/strict";
import { hairstyle, wholeHead } from "../hairstyles.mjs";

const kTimes = 3;

/**
 * Runs in the page: moves the slider of a label by one, and takes the times until the service has answered and until the new hair
 * has been drawn, two frames later. `frames` is how long two frames take when only the view is turned.
 */
async function timeOf(label) {
  const slider = [...document.querySelectorAll(".slider")].find((one) => one.querySelector("label")?.textContent === label)?.querySelector("input[type=range]");
  const nextFrame = () => new Promise((done) => requestAnimationFrame(done));
  await nextFrame();
  const turned = performance.now();
  document.querySelector(".stage-canvas").dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
  await nextFrame();
  await nextFrame();
  const frames = performance.now() - turned;
  for (let i = 0; i < 3; i++) await nextFrame(); // until nothing of that is under way
  const begin = performance.now();
  let answered = 0;
  const observer = new PerformanceObserver((list) => {
    for (const { name, startTime, responseEnd } of list.getEntries()) if (name.includes("/v1/") && startTime >= begin) answered = Math.max(answered, responseEnd);
  });
  observer.observe({ type: "resource" });
  slider.valueAsNumber += Number(slider.step);
  slider.dispatchEvent(new Event("input", { bubbles: true }));
  while (answered === 0) await new Promise((done) => setTimeout(done, 0));
  await nextFrame();
  await nextFrame();
  observer.disconnect();
  return { answered: answered - begin, drawn: performance.now() - begin, frames };
}

const middle = (numbers) => [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)];

/** How long it takes from a slider's movement to the new hair, for one lock and for a head of 200. It is told, not judged: machines differ. */
export async function answersAtOnce({ open, say }) {
  for (const [count, all] of [[1, false], [200, false], [200, true]]) {
    const studio = await open({ width: 640, height: 360, kept: hairstyle(wholeHead(count)) }); // a small picture: here software draws it
    await studio.mode("Shape");
    await studio.page.locator(".tuft-name").first().click();
    if (all) await studio.page.locator(".tuft-name").last().click({ modifiers: ["Shift"] });
    await studio.settle();
    const times = [];
    for (let i = 0; i < kTimes; i++) {
      times.push(await studio.page.evaluate(timeOf, "Thickness"));
      await studio.settle();
    }
    const [answered, drawn, frames] = ["answered", "drawn", "frames"].map((name) => Math.round(middle(times.map((time) => time[name]))));
    say(`${all ? count : 1} of ${count} changed: answered after ${answered} ms, drawn after ${drawn} ms, of which two frames take ${frames} ms (medians of ${kTimes})`);
    assert.ok(drawn > 0);
    await studio.page.context().close();
  }
}
