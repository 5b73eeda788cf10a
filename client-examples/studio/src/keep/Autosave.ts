import { fromHairstyle } from "../model/fromHairstyle";
import { toHairstyle } from "../model/toHairstyle";
import type { Hairstyle } from "../api/contract";
import { Signal } from "../base/Signal";
import type { Studio } from "../Studio";

const kKey = "tuftwave.document";
const kPause_ms = 400;

interface Kept {
  readonly name: string;
  readonly hairstyle: Hairstyle;
}

/** Keeps the document in this browser a moment after each change, and brings it back at the start. */
export class Autosave {
  /** Whether the last change is kept; false where the browser keeps nothing. */
  readonly isKept = new Signal(true);
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly studio: Studio) {
    this.restore();
    studio.history.current.changed(() => {
      clearTimeout(this.timer);
      this.timer = setTimeout(() => this.keep(), kPause_ms);
    });
    window.addEventListener("pagehide", () => this.keep());
  }

  private keep(): void {
    const kept: Kept = { name: this.studio.document.name, hairstyle: toHairstyle(this.studio.document) };
    try {
      localStorage.setItem(kKey, JSON.stringify(kept));
      this.isKept.value = true;
    } catch {
      this.isKept.value = false;
    }
  }

  private restore(): void {
    try {
      const kept = JSON.parse(localStorage.getItem(kKey) ?? "null") as Kept | null;
      if (kept) this.studio.history.begin(fromHairstyle(kept.hairstyle, kept.name));
    } catch {
      localStorage.removeItem(kKey); // of another time, or half written
    }
  }
}
