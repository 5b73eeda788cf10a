import { element } from "../base/element";
import type { takeAwayText } from "../text/takeAwayText";
import { choice } from "../widgets/choice";
import type { PictureLook, PictureParts } from "./CyclePainter";
import type { Cycle } from "./takePictures";

const kSmallest = 512; // pixels
const kLargest = 4096;
const kUsual = 1024;
const kPreview = 320; // pixels of its longer side, shown at half that size

/** How the pictures are to look: the choices, the first picture with them, and how far they are. */
export class PicturesPart {
  readonly element: HTMLFieldSetElement;
  readonly progress: HTMLProgressElement;
  private parts: PictureParts = "head";
  private readonly width: HTMLInputElement;
  private readonly height: HTMLInputElement;
  private readonly preview: HTMLElement;
  private readonly summary = element("p", { className: "take-summary" });
  private cycle: Cycle | null = null;

  constructor(private readonly words: typeof takeAwayText.en) {
    const shown = choice(words.shown, (["head", "hair", "cutOut"] as const).map((parts) => [parts, words.shownParts[parts]] as const), (value) => {
      this.parts = value;
      help.hidden = value !== "cutOut";
      this.paint();
    });
    shown.set("head");
    const help = element("p", { className: "help", hidden: true, role: "status" }, words.shownHelp);
    this.width = this.sizeInput();
    this.height = this.sizeInput();
    this.preview = element("div", { className: "take-preview", role: "img", aria: { label: words.preview } });
    const size = (name: string, input: HTMLInputElement) =>
      element("label", { className: "take-size" }, element("span", {}, name), input, element("span", {}, words.pixels));
    this.progress = element("progress", { className: "take-progress", hidden: true, value: 0, aria: { label: words.takePictures } });
    this.element = element("fieldset", { className: "take-pictures", aria: { label: words.pictures } }, this.preview,
      element("div", { className: "take-choices" }, shown.element, help, size(words.width, this.width), size(words.height, this.height), this.summary));
  }

  get look(): PictureLook {
    return { parts: this.parts, width: sizeOf(this.width), height: sizeOf(this.height) };
  }

  /** Shows the first picture of a cycle; null shows none. The cycle stays the caller's. */
  show(cycle: Cycle | null): void {
    this.cycle = cycle;
    this.summary.textContent = cycle ? this.words.summary(cycle.schedule.pictures, cycle.schedule.frames, String(cycle.schedule.fps)) : "";
    this.paint();
  }

  private paint(): void {
    const { width, height, parts } = this.look;
    const scale = kPreview / Math.max(width, height);
    Object.assign(this.preview.style, { width: `${(scale * width) / 2}px`, height: `${(scale * height) / 2}px` });
    const first = this.cycle?.painter.paint(0, { parts, width: Math.round(scale * width), height: Math.round(scale * height) });
    this.preview.replaceChildren(...(first ? [first] : []));
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
