import { ServiceAway } from "../api/ServiceAway";
import { ServiceProblem } from "../api/ServiceProblem";
import { element } from "../base/element";
import { toHairstyle } from "../model/toHairstyle";
import type { HairStage } from "../stage/HairStage";
import type { Studio } from "../Studio";
import { faultText } from "../text/faultText";
import type { takeAwayText } from "../text/takeAwayText";
import { Dialog } from "../widgets/Dialog";
import { group } from "../widgets/group";
import { CyclePainter } from "./CyclePainter";
import { download } from "./download";
import { fileName } from "./fileName";
import { hairstyleFile } from "./hairstyleFile";
import { loadCycle } from "./loadCycle";
import { PicturesPart } from "./PicturesPart";
import { takePictures, type Cycle } from "./takePictures";
import "./takeAway.css";

type Work = (signal: AbortSignal) => Promise<void>;
type Words = typeof takeAwayText.en;

const kOthers = ["vmd", "bvh", "usda"] as const;

/** Everything that can be taken away of the hairstyle. What goes wrong stands where it was asked for; closing ends what is under way. */
export class TakeAwayDialog {
  private readonly dialog: Dialog;
  private readonly buttons: HTMLButtonElement[] = [];
  private readonly nothing: HTMLElement;
  private readonly status = element("p", { className: "take-status", role: "status" });
  private readonly problem = element("div", { className: "take-problem", role: "alert" });
  private readonly part: PicturesPart;
  private readonly picturesGroup: HTMLElement;
  /** Ends when the dialog closes, and with it all that is under way. */
  private opened = new AbortController();
  private cycle: Promise<Cycle> | null = null;

  constructor(private readonly studio: Studio, private readonly stage: HairStage, private readonly words: Words) {
    this.part = new PicturesPart(words);
    this.nothing = element("p", { className: "take-nothing", id: "take-nothing" }, words.nothing);
    const help = (text: string) => element("p", { className: "help" }, text);
    const take = this.button(words.takePictures, (signal) => this.takePictures(signal), "primary");
    this.picturesGroup = group(words.pictures, help(words.picturesHelp), this.part.element, take, this.part.progress);
    this.dialog = new Dialog(words.title, words.close, this.nothing,
      group(words.hairstyle, help(words.hairstyleHelp), element("div", { className: "take-row" },
        this.button(words.json, async () => this.give("json", hairstyleFile(studio.document), "application/json")),
        this.button(words.glb, (signal) => this.takeFile("glb", "model/gltf-binary", signal)))),
      this.picturesGroup,
      group(words.others, help(words.othersHelp), element("div", { className: "take-row" },
        ...kOthers.map((format) => this.button(words.otherFormats[format], (signal) => this.takeFile(format, "application/octet-stream", signal))))),
      this.status);
    this.dialog.element.classList.add("take-away");
    // The key that opened it; the browser would save the page.
    this.dialog.element.addEventListener("keydown", (event) => {
      if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "s") event.preventDefault();
    });
    this.dialog.onClose = () => this.leave();
  }

  show(): void {
    if (this.dialog.isOpen) return;
    const isEmpty = this.studio.document.tufts.length === 0;
    this.nothing.hidden = !isEmpty;
    this.say("");
    this.problem.remove();
    this.opened = new AbortController();
    this.rest(isEmpty);
    this.dialog.show();
    const { signal } = this.opened;
    if (!isEmpty) this.load(signal).catch((error: unknown) => !signal.aborted && this.showProblem(this.picturesGroup, error));
  }

  private leave(): void {
    this.opened.abort();
    this.part.show(null);
    this.part.progress.hidden = true;
    this.cycle?.then(({ painter }) => painter.dispose(), () => {});
    this.cycle = null;
  }

  private button(label: string, work: Work, className = "plain"): HTMLButtonElement {
    const button = element("button", { type: "button", className, onclick: () => void this.attempt(button, work) }, label);
    this.buttons.push(button);
    return button;
  }

  /** One thing at a time. What goes wrong stands below the button that asked for it. */
  private async attempt(button: HTMLButtonElement, work: Work): Promise<void> {
    const { signal } = this.opened;
    this.problem.remove();
    this.rest(true);
    try {
      await work(signal);
    } catch (error) {
      if (!signal.aborted) this.showProblem(button.closest(".group") ?? this.picturesGroup, error);
    }
    if (signal.aborted) return;
    this.part.progress.hidden = true;
    this.rest(false);
    button.focus({ preventScroll: true }); // it had to let go of it while it was disabled
  }

  /** The first picture and all others: asked for once while the dialog is open. */
  private load(signal: AbortSignal): Promise<Cycle> {
    this.cycle ??= this.makeCycle(signal).catch((error: unknown) => {
      if (!signal.aborted) this.cycle = null; // the next try may do better
      throw error;
    });
    return this.cycle;
  }

  private async makeCycle(signal: AbortSignal): Promise<Cycle> {
    const { hair, schedule } = await loadCycle(this.studio, signal);
    signal.throwIfAborted();
    const cycle = { schedule, painter: new CyclePainter(this.stage, hair, this.studio.document.color) };
    this.part.show(cycle);
    return cycle;
  }

  private async takePictures(signal: AbortSignal): Promise<void> {
    const { progress, look } = this.part;
    this.say(this.words.asking);
    const cycle = await this.load(signal);
    Object.assign(progress, { hidden: false, max: cycle.schedule.pictures, value: 0 });
    const zip = await takePictures(this.studio, cycle, look, this.words, signal, (done) => {
      progress.value = done;
      this.say(this.words.painting(Math.min(done + 1, progress.max), progress.max));
    });
    this.give("zip", zip, "application/zip");
  }

  private async takeFile(format: string, type: string, signal: AbortSignal): Promise<void> {
    this.say(this.words.asking);
    const bytes = await this.studio.service.bytes("/v1/hairstyles", { body: toHairstyle(this.studio.document), query: { format }, signal }, "*/*");
    this.give(format, bytes, type);
  }

  private give(ending: string, content: BlobPart, type: string): void {
    const file = `${fileName(this.studio.document.name)}.${ending}`;
    download(file, content, type);
    this.say(this.words.done(file));
  }

  private say(text: string): void {
    this.status.textContent = text;
  }

  /** Whether nothing can be asked for: there is no hair, or something is under way. */
  private rest(isResting: boolean): void {
    this.part.element.disabled = isResting;
    for (const button of this.buttons) {
      button.disabled = isResting;
      if (this.nothing.hidden) button.removeAttribute("aria-describedby");
      else button.setAttribute("aria-describedby", this.nothing.id);
    }
  }

  private showProblem(place: Element, error: unknown): void {
    this.say("");
    this.problem.replaceChildren(...this.linesOf(error).map((line) => element("p", {}, line)));
    place.append(this.problem);
    this.problem.scrollIntoView({ block: "nearest" });
  }

  private linesOf(error: unknown): readonly string[] {
    if (error instanceof ServiceAway) return [this.words.away];
    if (!(error instanceof ServiceProblem)) return [this.words.failed(error instanceof Error ? error.message : String(error))];
    const { fields, message } = error;
    return [this.words.refused, ...(fields.length > 0 ? fields.map((fault) => `${fault.pointer}: ${faultText(fault)}`) : [message])];
  }
}
