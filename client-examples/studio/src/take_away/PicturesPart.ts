import { element } from "../base/element";
import type { takeAwayText } from "../text/takeAwayText";
import { choice } from "../widgets/choice";
import type { PictureLook } from "./CyclePainter";
import type { Cycle } from "./takePictures";

const kSmallest = 512; // pixels
const kLargest = 4096;
const kUsual = 1024;
const kPreview = 320; // pixels of its longer side, shown at half that size

/** How the pictures are to look: the choices, the first picture with them, and how far they are. */
export class PicturesPart {
  readonly element: HTMLFieldSetElement;
  readonly progress: HTMLProgressElement;
  private withHead = true;
  private readonly width: HTMLInputElement;
  private readonly height: HTMLInputElement;
  private readonly preview: HTMLElement;
  private readonly summary = element("p", { className: "take-summary" });
  private cycle: Cycle | null = null;

  constructor(private readonly words: typeof takeAwayText.en) {
    const shown = choice(words.shown, [["head", words.shownParts.withHead], ["hair", words.shownParts.hairOnly]] as const, (value) => {
      this.withHead = value === "head";
      this.paint();
    });
    shown.set("head");
    this.width = this.sizeInput();
    this.height = this.sizeInput();
    this.preview = element("div", { className: "take-preview", role: "img", aria: { label: words.preview } });
    const size = (name: string, input: HTMLInputElement) => element("label", { className: "take-size" }, element("span", {}, name), input, element("span", {}, words.pixels));
    this.progress = element("progress", { className: "take-progress", hidden: true, value: 0, aria: { label: words.takePictures } });
    this.element = element("fieldset", { className: "take-pictures", aria: { label: words.pictures } }, this.preview,
      element("div", { className: "take-choices" }, shown.element, size(words.width, this.width), size(words.height, this.height), this.summary));
  }

  get look(): PictureLook {
    return { withHead: this.withHead, width: sizeOf(this.width), height: sizeOf(this.height) };
  }

  /** Shows the first picture of a cycle; null shows none. The cycle stays the caller's. */
  show(cycle: Cycle | null): void {
    this.cycle = cycle;
    this.summary.textContent = cycle ? this.words.summary(cycle.schedule.pictures, cycle.schedule.frames, String(cycle.schedule.fps)) : "";
    this.paint();
  }

  private paint(): void {
    const { width, height, withHead } = this.look;
    this.preview.style.aspectRatio = `${width} / ${height}`;
    if (!this.cycle) return this.preview.replaceChildren();
    const scale = kPreview / Math.max(width, height);
    this.preview.replaceChildren(this.cycle.painter.paint(0, { withHead, width: Math.max(1, Math.round(scale * width)), height: Math.max(1, Math.round(scale * height)) }));
  }

  private sizeInput(): HTMLInputElement {
    const input = element("input", {
      type: "number", min: String(kSmallest), max: String(kLargest), step: "1", value: String(kUsual),
      onchange: () => {
        input.value = String(sizeOf(input));
        this.paint();
      },
    });
    return input;
  }
}

function sizeOf(input: HTMLInputElement): number {
  const typed = input.valueAsNumber;
  return Number.isFinite(typed) ? Math.round(Math.max(kSmallest, Math.min(kLargest, typed))) : kUsual;
}
