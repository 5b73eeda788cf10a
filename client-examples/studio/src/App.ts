import { element } from "./base/element";
import type { Part } from "./base/Part";
import { Bringing } from "./bring/Bringing";
import { FillPreview } from "./fill/FillPreview";
import { modeBar } from "./frame/modeBar";
import { sidePanel } from "./frame/sidePanel";
import { stageArea } from "./frame/stageArea";
import { timeline } from "./frame/timeline";
import { topBar } from "./frame/topBar";
import { helpDialog } from "./help/helpDialog";
import { Autosave } from "./keep/Autosave";
import { Player } from "./motion/Player";
import type { Transport } from "./motion/Transport";
import type { PaintedHead } from "./paint/PaintedHead";
import { Fields } from "./panels/Fields";
import { shortcuts } from "./shortcuts";
import { HairStage } from "./stage/HairStage";
import type { Studio } from "./Studio";
import { TakeAwayDialog } from "./take_away/TakeAwayDialog";
import { appText } from "./text/appText";
import { language } from "./text/language";
import { takeAwayText } from "./text/takeAwayText";
import "./app.css";
import "./bring/bring.css";

/** The page: the picture, which stays, and around it what is made anew in another language. */
export class App {
  readonly element = element("div", { className: "app" });
  readonly stage: HairStage;
  readonly player = new Player();
  readonly bring: Bringing;
  readonly preview: FillPreview;
  readonly fields = new Fields();
  readonly autosave: Autosave;
  private transport: Transport | null = null;
  private takeAwayDialog: TakeAwayDialog | null = null;
  private parts: readonly Part[] = [];

  constructor(readonly studio: Studio, head: PaintedHead) {
    this.preview = new FillPreview(studio);
    this.stage = new HairStage(studio, this.preview, this.player, head);
    this.autosave = new Autosave(studio);
    this.bring = new Bringing(studio, this.stage);
    language.follow(() => this.build());
    window.addEventListener("keydown", (event) => shortcuts(event, this));
  }

  get words(): typeof appText.en {
    return appText[language.value];
  }

  /** Keys of playback. @return  whether it has a use for this one */
  playbackKey(event: KeyboardEvent): boolean {
    return this.studio.mode.value === "move" && (this.transport?.handleKey(event) ?? false);
  }

  help(): void {
    helpDialog(language.value).show();
  }

  /** Asks for a file to open. */
  openFile(): void {
    this.element.querySelector<HTMLInputElement>(".open-file")?.click();
  }

  /** Asks what to take away of the hairstyle. */
  takeAway(): void {
    this.takeAwayDialog?.show();
  }

  private build(): void {
    for (const part of this.parts) part.dispose();
    document.title = this.words.title;
    this.takeAwayDialog = new TakeAwayDialog(this.studio, this.stage, takeAwayText[language.value]);
    const time = timeline(this);
    this.transport = time.transport;
    const [top, modes, stage, side] = [topBar(this), modeBar(this), stageArea(this), sidePanel(this)];
    this.parts = [time, top, modes, stage, side];
    this.element.replaceChildren(top.element, element("main", { className: "workspace" }, modes.element, stage.element, side.element), time.element);
  }
}
