import { chromium } from "playwright-core";
import { beforePage } from "./beforePage.mjs";
import { StudioPage } from "./StudioPage.mjs";
import { Watch } from "./Watch.mjs";

const kArguments = [
  "--no-sandbox", "--enable-unsafe-swiftshader", "--force-color-profile=srgb", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
];

/** One Chromium; each page it opens is a visitor of its own, who was never here before. */
export class Browser {
  #browser;
  #open = [];

  constructor(browser) {
    this.#browser = browser;
  }

  static async launch() {
    return new Browser(await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: kArguments }));
  }

  get pages() {
    return this.#open;
  }

  /**
   * Opens the studio and waits until it is there. Small, and without motion that starts by itself, unless asked otherwise.
   * @param kept  the document of an earlier visit, { name, hairstyle }
   */
  async open(url, { width = 768, height = 500, locale = "en-US", colorScheme = "light", reducedMotion = "reduce", kept = null, antialias = false, ...more } = {}) {
    const context = await this.#browser.newContext({ viewport: { width, height }, locale, colorScheme, reducedMotion, ...more });
    await context.addInitScript(beforePage, { kept, antialias });
    const page = await context.newPage();
    page.setDefaultTimeout(15_000);
    const studio = new StudioPage(page, new Watch(page, new URL(url).origin));
    this.#open.push(studio);
    await page.goto(url);
    await studio.ready();
    return studio;
  }

  /** Closes all pages, and says what they did that no page may. */
  async closePages() {
    const faults = this.#open.flatMap(({ watch }) => watch.faults);
    await Promise.all(this.#open.splice(0).map(({ page }) => page.context().close()));
    return faults;
  }

  close() {
    return this.#browser.close();
  }
}
