import type { Schedule } from "../api/contract";
import type { motionText } from "../text/motionText";
import { frameRate } from "./frameRate";
import { make } from "./make";
import "./motion.css";
import { pictureOfFrame } from "./pictureOfFrame";
import { seekKey } from "./seekKey";
import { SheetColumns } from "./SheetColumns";
import { wrap } from "./wrap";

/** Where the current frame comes to stand when the sheet turns its page, as a share of what is seen. */
const kPageStart = 0.12;

/**
 * The exposure sheet of one cycle, from left to right, which is also the slider of playback: pointer and keys seek.
 * It only reports what was sought; whoever listens answers with showFrame. dispose() ends its observing.
 */
export class ExposureSheet {
  readonly element: HTMLElement;
  /** Called with a frame, from 0, when a person seeks one. */
  onSeek: (frame: number) => void = () => {};
  readonly #words: typeof motionText.en.sheet;
  readonly #columns = new SheetColumns();
  readonly #slider: HTMLElement;
  readonly #facts = make("p", "sheet-facts");
  readonly #position = make("span", "sheet-position");
  readonly #resized = new ResizeObserver(() => this.#measure());
  #schedule: Schedule | null = null;
  #frame = 0;
  #seen = 0;
  #left = 0;
  #columnWidth = 0;
  #dragging = false;

  constructor(words: typeof motionText.en) {
    this.#words = words.sheet;
    this.#slider = make("div", "sheet-slider", this.#columns.element);
    const names = make("div", "sheet-names", make("span", "", this.#words.frame), make("span", "", this.#words.picture));
    names.ariaHidden = this.#position.ariaHidden = "true";
    const head = make("div", "sheet-head", make("h3", "", this.#words.title), this.#facts, this.#position);
    this.element = make("section", "motion exposure-sheet", head, make("div", "sheet-paper", names, this.#slider));
    this.element.ariaLabel = this.#words.title;
    this.#slider.setAttribute("role", "slider");
    this.#slider.ariaLabel = this.#words.title;
    this.#slider.addEventListener("keydown", (event) => this.#onKey(event));
    this.#slider.addEventListener("pointerdown", (event) => this.#onDown(event));
    this.#slider.addEventListener("pointermove", (event) => this.#dragging && this.#seekTo(event.clientX));
    for (const end of ["pointerup", "pointercancel"] as const) this.#slider.addEventListener(end, () => (this.#dragging = false));
    this.#slider.addEventListener("scroll", () => (this.#left = this.#slider.scrollLeft), { passive: true });
    this.#resized.observe(this.#slider);
    this.update(null);
  }

  /** Shows another schedule, or without one an empty sheet. */
  update(schedule: Schedule | null): void {
    this.#schedule = schedule;
    this.element.classList.toggle("empty", schedule === null);
    this.#slider.tabIndex = schedule ? 0 : -1;
    this.#slider.ariaDisabled = String(schedule === null);
    this.#writeFacts(schedule);
    if (schedule) this.#columns.write(schedule);
    this.#measure();
    this.showFrame(this.#frame);
  }

  /**
   * Marks a frame and its picture and scrolls them into sight.
   * @param frame  any whole number; the sheet goes round
   */
  showFrame(frame: number): void {
    const schedule = this.#schedule;
    this.#frame = schedule ? wrap(frame, schedule.frames) : frame;
    const picture = schedule ? pictureOfFrame(schedule, this.#frame) : 0;
    if (schedule) this.#columns.light(this.#frame, schedule.starts[picture] ?? 0, schedule.holds[picture] ?? 1);
    const position = schedule ? this.#words.position(this.#frame + 1, schedule.frames, picture + 1) : this.#words.empty;
    // Figure spaces keep the width of what is seen, or the line beside it would wrap to and fro.
    const longest = schedule ? this.#words.position(schedule.frames, schedule.frames, schedule.pictures).length : 0;
    this.#position.textContent = position.padStart(longest, "\u2007");
    this.#slider.ariaValueMin = "1";
    this.#slider.ariaValueMax = String(schedule?.frames ?? 1);
    this.#slider.ariaValueNow = String(schedule ? this.#frame + 1 : 1);
    this.#slider.ariaValueText = position;
    this.#follow();
  }

  dispose(): void {
    this.#resized.disconnect();
  }

  #writeFacts(schedule: Schedule | null): void {
    if (!schedule) return this.#facts.replaceChildren();
    const { fps, frames, pictures, period, requested_period } = schedule;
    const words = this.#words;
    const rate = typeof fps === "string" && fps.includes("/") ? `${frameRate(fps).toFixed(3)} (${fps})` : String(fps);
    const counts = [words.fps(rate), words.frames(frames), words.pictures(pictures)];
    const [made, asked] = [period, requested_period].map((seconds) => seconds.toFixed(3)) as [string, string];
    const facts = [...counts, words.period(made), ...(asked === made ? [] : [words.requested(asked)])];
    this.#facts.replaceChildren(...facts.flatMap((fact) => [make("span", "", fact), " "]));
  }

  /** Widths are read only here, and the place by the scroll event, so that playback never waits for layout. */
  #measure(): void {
    this.#seen = this.#slider.clientWidth;
    this.#columnWidth = this.#columns.columnWidth;
    this.#follow();
  }

  #follow(): void {
    const from = this.#frame * this.#columnWidth;
    const to = from + this.#columnWidth;
    if (from >= this.#left && to <= this.#left + this.#seen) return;
    // In playback a page turns; under a dragging hand the sheet moves no more than it must.
    const dragged = from < this.#left ? from : to - this.#seen;
    this.#left = Math.max(this.#dragging ? dragged : from - kPageStart * this.#seen, 0);
    this.#slider.scrollLeft = this.#left;
  }

  #onKey(event: KeyboardEvent): void {
    if (!this.#schedule || event.ctrlKey || event.metaKey || event.altKey) return;
    const frame = seekKey(this.#schedule, this.#frame, event.key, event.shiftKey);
    if (frame === null) return;
    event.preventDefault();
    // The page's own keys must not step once more.
    event.stopPropagation();
    this.onSeek(frame);
  }

  #onDown(event: PointerEvent): void {
    if (!this.#schedule || event.button !== 0) return;
    this.#slider.setPointerCapture(event.pointerId);
    this.#dragging = true;
    this.#seekTo(event.clientX);
  }

  #seekTo(clientX: number): void {
    if (!this.#schedule || this.#columnWidth === 0) return;
    const x = clientX - this.#slider.getBoundingClientRect().left + this.#slider.scrollLeft;
    const frame = Math.min(Math.max(Math.floor(x / this.#columnWidth), 0), this.#schedule.frames - 1);
    if (frame !== this.#frame) this.onSeek(frame);
  }
}
