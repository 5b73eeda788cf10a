import type { Schedule } from "../api/contract";
import { frameRate } from "./frameRate";
import { make } from "./make";

interface Column {
  readonly element: HTMLElement;
  readonly picture: HTMLElement;
}

/** Frames of a beat, emphasized as on paper: half seconds where those are whole, else seconds. At 24 fps it is 12. */
function beatOf(rate: number): number {
  return rate >= 8 && rate % 2 === 0 ? rate / 2 : rate;
}

/**
 * The columns of an exposure sheet, one per frame: its number over its cell. A cell has the picture's number where the picture
 * starts and a line where it is held. Columns stay when the sheet changes, and light touches only what it leaves and enters.
 */
export class SheetColumns {
  readonly element = make("div", "sheet-columns");
  readonly #columns: Column[] = [];
  #current: HTMLElement | null = null;
  #lit: readonly HTMLElement[] = [];

  /** The width of a column, CSS pixels, 0 before any is on the page. Reads layout. */
  get columnWidth(): number {
    return this.#columns[0]?.element.getBoundingClientRect().width ?? 0;
  }

  /** Writes a sheet. */
  write(schedule: Schedule): void {
    this.light(null, 0, 0);
    this.#resize(schedule.frames);
    const second = Math.max(Math.round(frameRate(schedule.fps)), 1);
    const beat = beatOf(second);
    schedule.starts.forEach((start, picture) => {
      const end = start + (schedule.holds[picture] ?? 1);
      for (let frame = start; frame < end; ++frame) {
        const ends = (length: number) => (frame + 1) % length === 0;
        const marks = [frame === start ? "start" : "held", frame + 1 < end && "goes-on", ends(beat) && "beat", ends(second) && "second"];
        this.#writeColumn(frame, frame === start ? String(picture + 1) : "", marks.filter(Boolean).join(" "));
      }
    });
  }

  /**
   * Marks the current frame and the cells of its picture.
   * @param frame  null for none
   * @param start  the picture's first frame
   * @param hold  its number of frames
   */
  light(frame: number | null, start: number, hold: number): void {
    const current = frame === null ? null : (this.#columns[frame]?.element ?? null);
    const lit = frame === null ? [] : this.#columns.slice(start, start + hold).map(({ element }) => element);
    if (current !== this.#current) {
      this.#current?.classList.remove("current");
      current?.classList.add("current");
      this.#current = current;
    }
    if (lit[0] === this.#lit[0] && lit.length === this.#lit.length) return;
    for (const element of this.#lit) element.classList.remove("lit");
    for (const element of lit) element.classList.add("lit");
    this.#lit = lit;
  }

  #writeColumn(frame: number, picture: string, marks: string): void {
    const column = this.#columns[frame];
    if (!column) return;
    const className = `sheet-column ${marks}`;
    if (column.element.className !== className) column.element.className = className;
    if (column.picture.textContent !== picture) column.picture.textContent = picture;
  }

  #resize(count: number): void {
    for (const { element } of this.#columns.splice(count)) element.remove();
    const fresh = document.createDocumentFragment();
    for (let frame = this.#columns.length; frame < count; ++frame) {
      const number = make("span", "sheet-number", String(frame + 1));
      const picture = make("span", "sheet-picture");
      const element = make("div", "sheet-column", number, make("span", "sheet-cell", picture));
      this.#columns.push({ element, picture });
      fresh.append(element);
    }
    this.element.append(fresh);
  }
}
