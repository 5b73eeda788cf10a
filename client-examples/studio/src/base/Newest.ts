const kPatience_ms = 200;

/**
 * Work of which only the newest counts. One runs at a time; of those that come meanwhile the last one waits, and runs next. Work
 * that is still under way when a newer one has waited for 200 ms is aborted. So a slider that is dragged shows what can be had, and
 * a slow answer never stands in the way of the last.
 */
export class Newest {
  private running: AbortController | null = null;
  private next: ((signal: AbortSignal) => Promise<void>) | null = null;
  private timer: ReturnType<typeof setTimeout> | null = null;

  /** @param onFault  is told of what work throws without having been aborted; the next work runs nevertheless */
  constructor(private readonly onFault: (error: unknown) => void = (error) => globalThis.reportError(error)) {}

  /** @param work  what to do until it is aborted */
  start(work: (signal: AbortSignal) => Promise<void>): void {
    this.next = work;
    if (!this.running) void this.run();
    else this.timer ??= setTimeout(() => this.running?.abort(), kPatience_ms);
  }

  get isBusy(): boolean {
    return this.running !== null;
  }

  private async run(): Promise<void> {
    while (this.next) {
      const work = this.next;
      this.next = null;
      const running = (this.running = new AbortController());
      try {
        await work(running.signal);
      } catch (error) {
        if (!running.signal.aborted) this.onFault(error);
      }
      this.running = null;
      if (this.timer !== null) clearTimeout(this.timer);
      this.timer = null;
    }
  }
}
