const kPictureHeight_cm = 46; // what the page's view buttons show from top to bottom
const kMiddle_cm = -2; // and the height of its middle above the head's center
const kStep_px = 18; // between the places of a moving pointer
const kViews = { front: "Front", quarter: "Three quarter", left: "Left", right: "Right", back: "Back", top: "Top" };
const kModes = { draw: "Draw", shape: "Shape", fill: "Fill", move: "Move" };

/** A smooth way through all of `points` (Catmull-Rom). @param count  of places between two of them */
function handPath(points, count) {
  const at = (i) => points[Math.max(0, Math.min(points.length - 1, i))];
  const path = [points[0]];
  for (let i = 0; i + 1 < points.length; i++) {
    for (let k = 1; k <= count(points[i], points[i + 1]); k++) {
      const t = k / count(points[i], points[i + 1]);
      path.push([0, 1].map((axis) => {
        const [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)].map((point) => point[axis]);
        return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
      }));
    }
  }
  return path;
}

/** Someone who draws with the studio's page by pointer and keyboard, as a person does. Places are in centimetres as seen in the view. */
export class Artist {
  /** Names of all tufts, in the page's order; null for those of a fill. */
  names = [];
  #view = "";

  /** @param page  a page of playwright that shows the studio */
  constructor(page) {
    this.page = page;
  }

  async start() {
    this.box = await this.page.locator(".stage-canvas").boundingBox();
    this.names = [];
    this.#view = "";
  }

  async mode(mode) {
    await this.page.getByRole("navigation").getByRole("button", { name: kModes[mode] }).click();
  }

  /** @param view  "front", or with a turn by arrow keys: "left +2 -1" (two to the right, one down) */
  async look(view) {
    if (view === this.#view) return;
    const [base, aside = 0, up = 0] = view.split(" ");
    await this.page.getByRole("group", { name: "Look from" }).getByRole("button", { name: kViews[base], exact: true }).click();
    await this.page.locator(".stage-canvas").focus();
    for (const [turns, [less, more]] of [[Number(aside), ["ArrowLeft", "ArrowRight"]], [Number(up), ["ArrowDown", "ArrowUp"]]]) {
      for (let i = 0; i < Math.abs(turns); i++) await this.page.keyboard.press(turns < 0 ? less : more);
    }
    await this.page.waitForTimeout(50);
    this.#view = view;
  }

  async setNumber(field, value) {
    const input = this.page.locator(`[data-field="${field}"] .slider-number`);
    await input.fill(String(value));
    await input.blur();
  }

  async choose(group, label) {
    await this.page.locator(".panel").getByRole("group", { name: group, exact: true }).getByRole("radio", { name: label, exact: true }).check();
  }

  async toggle(label, isOn) {
    await this.page.locator(".panel").getByLabel(label, { exact: true }).setChecked(isOn);
  }

  pixel([x, y]) {
    const scale = this.box.height / kPictureHeight_cm;
    return [this.box.x + this.box.width / 2 + x * scale, this.box.y + this.box.height / 2 - (y - kMiddle_cm) * scale];
  }

  /** In one go. */
  async draw(view, points) {
    await this.look(view);
    const { mouse } = this.page;
    const pixels = points.map((point) => this.pixel(point));
    const path = handPath(pixels, ([x, y], [toX, toY]) => Math.max(2, Math.round(Math.hypot(toX - x, toY - y) / kStep_px)));
    await mouse.move(...path[0]);
    await mouse.down();
    for (const place of path.slice(1)) await mouse.move(...place);
    await mouse.up();
  }

  /** Point by point on the plane. */
  async click(view, points) {
    await this.look(view);
    for (const point of points) {
      await this.page.mouse.click(...this.pixel(point));
      await this.page.waitForTimeout(500); // two clicks in haste would end the stroke
    }
    await this.page.keyboard.press("Enter");
  }

  /** Point by point: the root in one view, the others in another, to which the plane is turned. */
  async bend([rootView, root], view, points) {
    await this.look(rootView);
    await this.page.mouse.click(...this.pixel(root));
    await this.look(view);
    await this.page.locator(".stage-canvas").focus();
    await this.page.keyboard.press("f");
    await this.page.waitForTimeout(500);
    await this.click(view, points);
  }

  async selectTufts(names) {
    await this.mode("shape");
    const rows = this.page.locator(".tuft-name");
    for (const [i, name] of names.entries()) {
      const place = this.names.indexOf(name);
      if (place < 0) throw new Error(`no tuft ${name}; there are ${this.names.filter(Boolean).join(" ")}`);
      await rows.nth(place).click({ modifiers: i === 0 ? [] : ["Control"] });
    }
  }

  /** Gives the tufts that were drawn the names by which the recipe knows them. */
  async rename() {
    await this.mode("shape");
    for (const [i, name] of this.names.entries()) {
      if (name === null) continue;
      await this.page.locator(".tuft-name").nth(i).press("F2");
      const input = this.page.locator(".tuft-rows input");
      await input.fill(name);
      await input.press("Enter");
    }
  }

  /** What the page keeps, {name, hairstyle}, as soon as it has all tufts by their names. */
  async kept() {
    const kept = await this.page.waitForFunction((names) => {
      const found = JSON.parse(localStorage.getItem("tuftwave.document"));
      const { tufts } = found.hairstyle;
      return tufts.length === names.length && names.every((name, i) => name === null || name === tufts[i].name) ? found : null;
    }, this.names, { polling: 200 });
    return kept.jsonValue();
  }
}
