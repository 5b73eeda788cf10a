import { Signal } from "../base/Signal";
import { moveToHead } from "../model/moveToHead";
import { newDocument } from "../model/newDocument";
import { loadBundledHead } from "../paint/loadBundledHead";
import type { PaintedHead } from "../paint/PaintedHead";
import type { HairStage } from "../stage/HairStage";
import type { Studio } from "../Studio";
import type { BroughtHead } from "./BroughtHead";
import { headFor } from "./headFor";
import { paintBytes } from "./paintBytes";

const kMost = 6; // heads that undoing finds again

interface Place {
  readonly head: BroughtHead["head"];
  /** null is the bundled head. */
  readonly brought: BroughtHead | null;
}

/**
 * The heads of this visit. Which one is shown follows from the document: the one with the measures that it names. So undo, redo,
 * opening and reloading show the head that the hair belongs on.
 */
export class HeadShelf {
  /** What is shown; null is the bundled head. */
  readonly shown = new Signal<BroughtHead | null>(null);
  private places: readonly Place[] = [{ head: newDocument().head, brought: null }];
  private wanted: BroughtHead | null = null;
  private ready: { readonly brought: BroughtHead; readonly painted: PaintedHead } | null = null;

  constructor(private readonly studio: Studio, private readonly stage: HairStage) {
    studio.history.current.changed(() => this.follow());
  }

  /** Puts a head on the shelf without showing it. @param painted  if it is painted already; it is this shelf's from now on */
  add(brought: BroughtHead, painted: PaintedHead | null = null): void {
    const [bundled, ...others] = this.places;
    const kept = others.filter(({ head }) => JSON.stringify(head) !== JSON.stringify(brought.head));
    this.places = [bundled!, { head: brought.head, brought }, ...kept].slice(0, kMost + 1);
    if (painted) {
      this.ready?.painted.dispose();
      this.ready = { brought, painted };
    }
  }

  /** Moves the document's hair to a head, as one step; null is the bundled one. */
  wear(brought: BroughtHead | null): void {
    const head = (this.places.find((place) => place.brought === brought) ?? this.places[0]!).head;
    const isWorn = JSON.stringify(this.studio.document.head) === JSON.stringify(head); // the same file again is no step
    if (!isWorn) this.studio.edit((document) => moveToHead(document, head));
    this.follow();
  }

  /** Shows the head that the document is for. */
  follow(): void {
    const { brought } = headFor(this.studio.document.head, this.places);
    if (brought === this.wanted) return;
    this.wanted = brought;
    this.show(brought).catch(() => brought && this.remove(brought));
  }

  /** One that could be kept but cannot be shown. */
  private remove(brought: BroughtHead): void {
    this.places = this.places.filter((place) => place.brought !== brought);
    this.follow();
  }

  private async show(brought: BroughtHead | null): Promise<void> {
    const painted = await this.paint(brought);
    if (this.wanted !== brought) return painted.dispose(); // another was asked for meanwhile
    if (brought) this.stage.setHead(painted, brought.ball, brought.head.front);
    else this.stage.setHead(painted);
    this.shown.value = brought;
  }

  private async paint(brought: BroughtHead | null): Promise<PaintedHead> {
    if (!brought) return loadBundledHead();
    const { ready } = this;
    this.ready = null;
    if (ready?.brought === brought) return ready.painted;
    ready?.painted.dispose();
    return paintBytes(brought.bytes, () => brought.ball);
  }
}
