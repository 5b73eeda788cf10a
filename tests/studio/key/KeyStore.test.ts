import { KeyStore } from "../../../client-examples/studio/src/key/KeyStore";

describe("KeyStore", () => {
  afterEach(() => void vi.unstubAllGlobals());

  it("keeps a key for the tab, and nowhere else", () => {
    const session = new Map<string, string>();
    vi.stubGlobal("sessionStorage", { getItem: (name: string) => session.get(name) ?? null, setItem: (name: string, text: string) => session.set(name, text), removeItem: (name: string) => session.delete(name) });
    const elsewhere = vi.fn();
    vi.stubGlobal("localStorage", { getItem: elsewhere, setItem: elsewhere });
    new KeyStore().value = "key";
    expect([...session.values()]).toEqual(["key"]);
    const next = new KeyStore();
    expect(next.value).toBe("key");
    next.value = null;
    expect(session.size).toBe(0);
    expect(elsewhere).not.toHaveBeenCalled();
  });

  it("remembers it itself where the browser keeps nothing", () => {
    const refuse = () => {
      throw new DOMException("denied", "SecurityError");
    };
    vi.stubGlobal("sessionStorage", { getItem: refuse, setItem: refuse, removeItem: refuse });
    const store = new KeyStore();
    expect(store.value).toBe(null);
    store.value = "key";
    expect(store.value).toBe("key");
  });
});
