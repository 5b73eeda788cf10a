import { Newest } from "../../../client-examples/studio/src/base/Newest";

/** Work that ends when it is told to, or is aborted. */
function work(log: string[], name: string) {
  let end = () => {};
  const run = (signal: AbortSignal) => new Promise<void>((resolve, reject) => {
    log.push(`${name} starts`);
    end = () => {
      log.push(`${name} ends`);
      resolve();
    };
    signal.addEventListener("abort", () => {
      log.push(`${name} aborted`);
      reject(new DOMException("", "AbortError"));
    });
  });
  return { run, end: () => end() };
}

const settled = async () => {
  for (let i = 0; i < 5; i++) await Promise.resolve();
};

describe("Newest", () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it("lets what is under way end, then runs only the last that came", async () => {
    const log: string[] = [];
    const [a, b, c] = ["a", "b", "c"].map((name) => work(log, name)) as [ReturnType<typeof work>, ReturnType<typeof work>, ReturnType<typeof work>];
    const newest = new Newest();
    newest.start(a.run);
    newest.start(b.run);
    newest.start(c.run);
    a.end();
    await settled();
    c.end();
    await settled();
    expect(log).toEqual(["a starts", "a ends", "c starts", "c ends"]);
    expect(newest.isBusy).toBe(false);
  });

  it("aborts what a newer one has waited for 200 ms", async () => {
    const log: string[] = [];
    const [a, b] = [work(log, "a"), work(log, "b")];
    const newest = new Newest();
    newest.start(a.run);
    newest.start(b.run);
    vi.advanceTimersByTime(199);
    expect(log).toEqual(["a starts"]);
    vi.advanceTimersByTime(1);
    await settled();
    expect(log).toEqual(["a starts", "a aborted", "b starts"]);
  });

  it("goes on after work that failed, and tells of it", async () => {
    const log: string[] = [];
    const faults: unknown[] = [];
    const newest = new Newest((fault) => faults.push(fault));
    newest.start(() => Promise.reject(new Error("broken")));
    await settled();
    const next = work(log, "next");
    newest.start(next.run);
    expect(log).toEqual(["next starts"]);
    expect(faults).toEqual([new Error("broken")]);
  });

  it("does not abort what nobody waits for", async () => {
    const log: string[] = [];
    const newest = new Newest();
    newest.start(work(log, "a").run);
    vi.advanceTimersByTime(10000);
    await settled();
    expect(log).toEqual(["a starts"]);
  });
});
