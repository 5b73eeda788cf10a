import { element } from "../base/element";
import type { Range } from "../api/rangeOf";
import "./widgets.css";

export interface SliderOptions {
  readonly label: string;
  /** Beside the number: a unit, or "%". */
  readonly unit?: string;
  /** What one would read about it; shown when one points at the label. */
  readonly hint?: string;
  /** From the contract; the track may be narrower, the number takes all of it. */
  readonly range: Range;
  readonly track?: { readonly minimum?: number; readonly maximum?: number };
  readonly step?: number;
  /** JSON pointer of the field without numbers, such as "/tufts/diameter", for problems. */
  readonly field: string;
  /** At every movement. */
  readonly onInput: (value: number) => void;
  /** When the movement ends. */
  readonly onSettle: () => void;
}

let made = 0;

/** A number by a track and by typing. Typed numbers are not held back: what is wrong with one, the service says. */
export class Slider {
  readonly element: HTMLElement;
  private readonly track: HTMLInputElement;
  private readonly number: HTMLInputElement;
  private readonly problem: HTMLElement;

  constructor(private readonly options: SliderOptions) {
    const { label, unit = "", hint, range, track = {}, field } = options;
    const step = String(options.step ?? (range.integer ? 1 : 0.01));
    const id = `slider-${++made}`;
    const [min, max] = [String(track.minimum ?? range.minimum), String(track.maximum ?? range.maximum)];
    this.track = element("input", { type: "range", id, min, max, step, oninput: () => this.take(this.track), onchange: options.onSettle });
    this.number = element("input", {
      type: "number", className: "slider-number", min: String(range.minimum), max: String(range.maximum), step: "any",
      oninput: () => this.take(this.number), onchange: options.onSettle, aria: { label: unit ? `${label}, ${unit}` : label, describedby: `${id}-problem` },
    });
    this.problem = element("p", { className: "field-problem", id: `${id}-problem`, hidden: true });
    this.element = element("div", { className: "slider", data: { field } },
      element("label", { htmlFor: id, title: hint ?? "" }, label),
      element("span", { className: "slider-value" }, this.number, unit && element("span", { className: "slider-unit" }, unit)),
      this.track, this.problem);
  }

  set(value: number): void {
    if (document.activeElement !== this.number || Number(this.number.value) !== value) this.number.value = String(Number(value.toFixed(4)));
    this.track.value = String(value);
    const { min, max } = this.track;
    this.track.style.setProperty("--filled", `${Math.max(0, Math.min(100, (100 * (value - Number(min))) / (Number(max) - Number(min))))}%`);
  }

  set isEnabled(enabled: boolean) {
    this.track.disabled = this.number.disabled = !enabled;
  }

  /** Shows what is wrong with the value, or nothing. */
  showProblem(text: string | null): void {
    this.problem.textContent = text ?? "";
    this.problem.hidden = text === null;
    this.number.setAttribute("aria-invalid", String(text !== null));
  }

  private take(input: HTMLInputElement): void {
    const value = input.valueAsNumber;
    if (!Number.isFinite(value)) return;
    const whole = this.options.range.integer ? Math.round(value) : value;
    this.set(whole);
    this.options.onInput(whole);
  }
}
