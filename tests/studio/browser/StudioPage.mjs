import { lookAtStage } from "./lookAtStage.mjs";
import { Pointer } from "./Pointer.mjs";
import { until } from "./until.mjs";

const kNarrowest = 0.85; // width of a picture to its height; a narrower one shows the head smaller

/** The studio as a visitor sees it: what is on it by its English names, and what comes of it. */
export class StudioPage {
  pointer;

  constructor(page, watch) {
    this.page = page;
    this.watch = watch;
    this.pointer = new Pointer(page);
  }

  async ready() {
    await this.page.locator(".stage-canvas").waitFor();
    await this.settle();
  }

  /** Waits until what has changed is drawn. */
  frames() {
    return this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  /** Waits until all that was asked for is loaded and drawn. */
  async settle() {
    await this.frames();
    for (;;) {
      await until("an end of loading", () => this.watch.isQuiet, 20_000);
      await this.frames();
      if (this.watch.isQuiet) return;
    }
  }

  /** The hairstyle as the page keeps it, { name, hairstyle }; it keeps it at once when it is left. */
  kept() {
    return this.page.evaluate(() => {
      window.dispatchEvent(new Event("pagehide"));
      return JSON.parse(localStorage.getItem("tuftwave.document"));
    });
  }

  async tufts() {
    return (await this.kept()).hairstyle.tufts;
  }

  /** See lookAtStage; with everything loaded. */
  async look() {
    await this.settle();
    return this.page.evaluate(lookAtStage);
  }

  /** A place of the window: from the middle of the picture right and down, in heights of the picture, as far as it is not narrow. */
  async at(x, y) {
    const box = await this.page.locator(".stage-canvas").boundingBox();
    const unit = Math.min(box.height, box.width / kNarrowest);
    return [box.x + box.width / 2 + x * unit, box.y + box.height / 2 + y * unit];
  }

  line(...places) {
    return Promise.all(places.map(([x, y]) => this.at(x, y)));
  }

  /** Draws a lock with the mouse, all at once. */
  async draw(...places) {
    await this.pointer.mouse(await this.line(...places));
    await this.settle();
  }

  async click(x, y, options) {
    await this.page.mouse.click(...(await this.at(x, y)), options);
  }

  async press(...keys) {
    for (const key of keys) await this.page.keyboard.press(key);
  }

  button(name) {
    return this.page.getByRole("button", { name, exact: true });
  }

  /** @param name  "Draw", "Shape", "Fill" or "Move" */
  async mode(name) {
    await this.page.locator(".mode-bar").getByRole("button", { name }).click();
    await this.settle();
  }

  /** The number of a slider by its label. */
  number(label) {
    return this.page.getByRole("spinbutton", { name: label });
  }

  /** Types into a slider's number, and leaves it. */
  async type(label, value) {
    await this.number(label).fill(String(value));
    await this.number(label).blur();
    await this.settle();
  }

  /** A tuft of the list in Shape. */
  row(name) {
    return this.page.locator(".tuft-name").getByText(name, { exact: true });
  }

  /** Where the handles of a kind are in the window, in their order. */
  async handles(kind) {
    await this.frames();
    const boxes = await this.page.locator(`.handle-${kind}`).evaluateAll((all) => all.map((one) => one.getBoundingClientRect()));
    return boxes.map(({ x, y, width, height }) => [x + width / 2, y + height / 2]);
  }

  /** Places of the window along the line of a selected tuft. */
  async linePlaces(number = 0) {
    await this.frames();
    return this.page.locator(".line-stroke").nth(number).evaluate((line) => {
      const { left, top } = line.ownerSVGElement.getBoundingClientRect();
      return [...line.points].map(({ x, y }) => [x + left, y + top]);
    });
  }
}
