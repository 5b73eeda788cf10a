const kName = "tuftwave.key";

/** The key for the service. Kept for this tab alone and until it closes; in memory only where the browser keeps nothing. */
export class KeyStore {
  private key: string | null = null;

  constructor() {
    try {
      this.key = sessionStorage.getItem(kName);
    } catch {
      // It keeps nothing, then.
    }
  }

  get value(): string | null {
    return this.key;
  }

  set value(key: string | null) {
    this.key = key;
    try {
      if (key === null) sessionStorage.removeItem(kName);
      else sessionStorage.setItem(kName, key);
    } catch {
      // The next page asks again.
    }
  }
}
