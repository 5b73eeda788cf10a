import { Doorkeeper } from "../../../client-examples/studio/src/key/Doorkeeper";

const store = (value: string | null = null) => ({ value });

describe("Doorkeeper", () => {
  it("asks once however many requests were refused, and keeps the answer", async () => {
    const ask = vi.fn(async () => "key-1");
    const keeper = new Doorkeeper(store(), ask);
    expect(await Promise.all([keeper.refused(null), keeper.refused(null)])).toEqual([true, true]);
    expect(ask.mock.calls).toEqual([[false]]);
    expect(keeper.key).toBe("key-1");
  });

  it("says so when it asks because a key was refused, and forgets that key", async () => {
    const kept = store("old");
    const ask = vi.fn(async () => {
      expect(kept.value).toBe(null);
      return "new";
    });
    expect(await new Doorkeeper(kept, ask).refused("old")).toBe(true);
    expect(ask.mock.calls).toEqual([[true]]);
    expect(kept.value).toBe("new");
  });

  it("does not ask for what it has learnt since the request was sent", async () => {
    const ask = vi.fn(async () => "other");
    expect(await new Doorkeeper(store("new"), ask).refused("old")).toBe(true);
    expect(ask).not.toHaveBeenCalled();
  });

  it("asks nobody again who gave no key", async () => {
    const ask = vi.fn(async () => null);
    const keeper = new Doorkeeper(store(), ask);
    expect(await keeper.refused(null)).toBe(false);
    expect(await keeper.refused(null)).toBe(false);
    expect(ask).toHaveBeenCalledTimes(1);
  });
});
