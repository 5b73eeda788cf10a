import type { KeyStore } from "./KeyStore";

/** Asks whoever sits there for a key. @param wasRefused  whether there was one @return  null if there is none */
export type AskForKey = (wasRefused: boolean) => Promise<string | null>;

/** Has the key that the service wants, and asks for it once however many requests were refused meanwhile. */
export class Doorkeeper {
  private asking: Promise<boolean> | null = null;
  private hasGivenUp = false;

  constructor(private readonly store: Pick<KeyStore, "value">, private readonly ask: AskForKey) {}

  get key(): string | null {
    return this.store.value;
  }

  /**
   * A request was refused. Whoever gave no key once is not asked again before the page loads anew.
   * @param used  the key that it was sent with
   * @return  whether there is another key to try
   */
  async refused(used: string | null): Promise<boolean> {
    if (this.store.value !== used) return this.store.value !== null; // another request has learnt a key since
    if (this.hasGivenUp) return false;
    this.asking ??= this.askAnew(used !== null).finally(() => (this.asking = null));
    return this.asking;
  }

  private async askAnew(wasRefused: boolean): Promise<boolean> {
    this.store.value = null;
    const key = await this.ask(wasRefused);
    this.hasGivenUp = key === null;
    this.store.value = key;
    return key !== null;
  }
}
