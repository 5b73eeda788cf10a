import type { Hairstyle } from "../api/contract";
import { Signal } from "../base/Signal";
import { fromHairstyle } from "../model/fromHairstyle";
import { toHairstyle } from "../model/toHairstyle";
import type { Studio } from "../Studio";
import { kept } from "./kept";

const kPause_ms = 400;

interface Kept {
  readonly name: string;
  readonly hairstyle: Hairstyle;
}

/** Keeps the document in this browser a moment after each change, and brings it back at the start. */
export class Autosave {
  /** Whether the last change is kept; false where the browser keeps nothing. */
  readonly isKept = new Signal(true);
  private readonly place = kept("tuftwave.document");
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
    const { name } = this.studio.document;
    this.isKept.value = this.place.write(JSON.stringify({ name, hairstyle: toHairstyle(this.studio.document) } satisfies Kept));
  }

  private restore(): void {
    try {
      const found = JSON.parse(this.place.read() ?? "null") as Kept | null;
      if (found) this.studio.history.begin(fromHairstyle(found.hairstyle, found.name));
    } catch {
      // Of another time, or half written: the next change is kept in its place.
    }
  }
}
