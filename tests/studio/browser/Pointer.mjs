const kSteps = 3; // between two places

const between = (places) => places.slice(1).flatMap((to, i) => Array.from({ length: kSteps }, (_, step) => {
  const from = places[i];
  return from.map((x, axis) => x + ((to[axis] - x) * (step + 1)) / kSteps);
}));

/** Strokes along places of the window, as the browser has them from a mouse, a pen or a finger. */
export class Pointer {
  #page;
  #session = null;

  constructor(page) {
    this.#page = page;
  }

  async mouse(places) {
    const { mouse } = this.#page;
    await mouse.move(...places[0]);
    await mouse.down();
    for (const place of places.slice(1)) await mouse.move(...place, { steps: kSteps });
    await mouse.up();
  }

  /** @param pressure  0..1 all along, or of the part of the way that is done */
  async pen(places, pressure) {
    const way = [places[0], ...between(places)];
    const force = (i) => (typeof pressure === "function" ? pressure(i / (way.length - 1)) : pressure);
    const send = (type, [x, y], more) => this.#send("Input.dispatchMouseEvent", { type, x, y, pointerType: "pen", ...more });
    await send("mousePressed", way[0], { button: "left", buttons: 1, clickCount: 1, force: force(0) });
    for (let i = 1; i < way.length; i++) await send("mouseMoved", way[i], { button: "left", buttons: 1, force: force(i) });
    await send("mouseReleased", way.at(-1), { button: "left", buttons: 0, clickCount: 1, force: 0 });
  }

  async finger(places) {
    const [start, ...way] = [places[0], ...between(places)];
    const send = (type, touches) => this.#send("Input.dispatchTouchEvent", { type, touchPoints: touches.map(([x, y]) => ({ x, y })) });
    await send("touchStart", [start]);
    for (const place of way) await send("touchMove", [place]);
    await send("touchEnd", []);
  }

  async #send(method, parameters) {
    this.#session ??= await this.#page.context().newCDPSession(this.#page);
    await this.#session.send(method, parameters);
  }
}
