/** What a page must not do unseen: complain on its console, throw, or load anything from elsewhere. */
export class Watch {
  #faults = [];
  #allowed = [];
  #pending = 0;

  /** @param origin  where alone the page may load from */
  constructor(page, origin) {
    page.on("console", (message) => message.type() === "error" && this.#note(`console: ${message.text()} ${message.location().url}`));
    page.on("pageerror", (error) => this.#note(`page error: ${error.stack ?? error.message}`));
    page.on("request", (request) => {
      this.#pending += 1;
      const { protocol, origin: from } = new URL(request.url());
      if (protocol.startsWith("http") && from !== origin) this.#note(`loaded from outside: ${request.url()}`);
    });
    for (const end of ["requestfinished", "requestfailed"]) page.on(end, () => (this.#pending -= 1));
  }

  /** Whether nothing is being loaded. */
  get isQuiet() {
    return this.#pending === 0;
  }

  get faults() {
    return this.#faults.filter((fault) => !this.#allowed.some((pattern) => pattern.test(fault)));
  }

  /** The browser itself reports refused and failed requests; a check that causes them says so. */
  allow(pattern) {
    this.#allowed.push(pattern);
  }

  #note(fault) {
    this.#faults.push(fault);
  }
}
