import { element } from "./base/element";
import { Bringing } from "./bring/Bringing";
import { bringNotice } from "./bring/bringNotice";
import { broughtLabel } from "./bring/broughtLabel";
import { DropTarget } from "./bring/DropTarget";
import { openButton } from "./bring/openButton";
import { CharacterPanel } from "./character/CharacterPanel";
import { theme, type Theme } from "./base/theme";
import { Autosave } from "./keep/Autosave";
import { FillPreview } from "./fill/FillPreview";
import { helpDialog } from "./help/helpDialog";
import { ExposureSheet } from "./motion/ExposureSheet";
import { Player } from "./motion/Player";
import { Transport } from "./motion/Transport";
import type { PaintedHead } from "./paint/PaintedHead";
import { DrawPanel } from "./panels/DrawPanel";
import { Fields } from "./panels/Fields";
import { FillPanel } from "./panels/FillPanel";
import { MovePanel } from "./panels/MovePanel";
import type { Panel } from "./panels/Panel";
import { ShapePanel } from "./panels/ShapePanel";
import { shortcuts } from "./shortcuts";
import { HairStage } from "./stage/HairStage";
import { kViews, type View } from "./stage/Viewport";
import type { Mode, Studio } from "./Studio";
import { appText } from "./text/appText";
import { language } from "./text/language";
import { motionText } from "./text/motionText";
import { panelText } from "./text/panelText";
import { takeAwayText } from "./text/takeAwayText";
import { TakeAwayDialog } from "./take_away/TakeAwayDialog";
import { iconButton } from "./widgets/iconButton";
import "./app.css";
import "./bring/bring.css";

const kModes: readonly Mode[] = ["draw", "shape", "fill", "move"];
const kThemes: readonly Theme[] = ["system", "light", "dark"];

/** The page: the picture, which stays, and around it what is made anew in another language. */
export class App {
  readonly element = element("div", { className: "app" });
  readonly stage: HairStage;
  readonly player = new Player();
  readonly bring: Bringing;
  private readonly preview: FillPreview;
  private readonly fields = new Fields();
  private transport: Transport | null = null;
  private panel: Panel | null = null;
  private endings: (() => void)[] = [];
  private takeAwayDialog: TakeAwayDialog | null = null;

  constructor(readonly studio: Studio, head: PaintedHead) {
    this.preview = new FillPreview(studio);
    this.stage = new HairStage(studio, this.preview, this.player, head);
    new Autosave(studio);
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

  /** Asks what to take away of the hairstyle. */
  takeAway(): void {
    this.takeAwayDialog?.show();
  }

  private build(): void {
    for (const end of this.endings) end();
    this.endings = [];
    document.title = this.words.title;
    this.takeAwayDialog = new TakeAwayDialog(this.studio, this.stage, takeAwayText[language.value]);
    this.element.replaceChildren(this.topBar(), element("main", { className: "workspace" }, this.modeBar(), this.stageArea(), this.panelArea()), this.timeline());
  }

  private topBar(): HTMLElement {
    const { studio, words } = this;
    const { history } = studio;
    const name = element("input", { type: "text", className: "document-name", maxLength: 60, aria: { label: words.documentName }, oninput: () => studio.edit((document) => ({ ...document, name: name.value }), "name"), onchange: () => history.settle() });
    const undo = iconButton("undo", words.undo, () => history.undo(), { shortcut: "Ctrl+Z" });
    const redo = iconButton("redo", words.redo, () => history.redo(), { shortcut: "Ctrl+Shift+Z" });
    this.endings.push(history.current.follow((document) => {
      if (name.value !== document.name) name.value = document.name;
      undo.disabled = !history.canUndo;
      redo.disabled = !history.canRedo;
    }));
    return element("header", { className: "top-bar" },
      element("h1", {}, "Tuftwave"), name,
      element("div", { className: "bar-group" }, undo, redo),
      element("div", { className: "bar-group" },
        iconButton("fresh", words.fresh, () => studio.edit(() => this.bring.fresh()), { shows_name: true }),
        openButton(words.open, (file) => void this.bring.open(file)),
        iconButton("save", words.takeAway, () => this.takeAway(), { shows_name: true, shortcut: "Ctrl+S" }),
      ),
      element("div", { className: "bar-space" }),
      element("div", { className: "bar-group" },
        iconButton("help", words.help, () => this.help(), { shortcut: "?" }),
        iconButton("sun", words.theme, () => (theme.value = kThemes[(kThemes.indexOf(theme.value) + 1) % kThemes.length]!)),
        element("button", { type: "button", className: "plain", lang: language.value === "en" ? "ja" : "en", onclick: () => (language.value = language.value === "en" ? "ja" : "en") }, words.language)));
  }

  private modeBar(): HTMLElement {
    const { studio, words } = this;
    const buttons = kModes.map((mode, i) => [mode, iconButton(mode, words.modeNames[mode], () => (studio.mode.value = mode), { shows_name: true, shortcut: String(i + 1), className: "mode" })] as const);
    this.endings.push(studio.mode.follow((current) => {
      for (const [mode, button] of buttons) button.setAttribute("aria-pressed", String(mode === current));
    }));
    return element("nav", { className: "mode-bar", aria: { label: words.modes } }, ...buttons.map(([, button]) => button));
  }

  private stageArea(): HTMLElement {
    const { studio, words, stage } = this;
    const views = element("div", { className: "view-bar", role: "group", aria: { label: words.views } },
      ...(Object.keys(kViews) as View[]).map((view) => element("button", { type: "button", onclick: () => stage.viewport.look(view) }, words.viewNames[view])));
    const hint = element("p", { className: "stage-hint" });
    const labels = element("div", { className: "compare-labels" }, element("span", {}, words.limited), element("span", {}, words.smooth));
    const away = element("p", { className: "stage-away", role: "status" });
    const problem = element("div", { className: "stage-problem", role: "alert" });
    const show = () => {
      const hasGuest = studio.mode.value === "move" && this.bring.guest.character.value !== null;
      const isEmpty = !hasGuest && studio.document.tufts.length === 0 && studio.drawn.value === null && !stage.draw.isClicking;
      hint.textContent = !isEmpty ? "" : studio.mode.value === "draw" ? words.hintEmpty : words.hintMove;
      hint.hidden = !isEmpty;
      labels.hidden = !(studio.mode.value === "move" && studio.compares.value);
    };
    for (const signal of [studio.history.current, studio.mode, studio.drawn, studio.compares, this.bring.guest.character]) this.endings.push(signal.changed(show));
    show();
    this.endings.push(studio.service.isHere.follow((isHere) => {
      away.textContent = isHere ? "" : words.away;
      away.hidden = isHere;
    }));
    this.endings.push(studio.problem.follow((one) => {
      const isShown = this.fields.show(one);
      problem.hidden = one === null || isShown;
      problem.replaceChildren(...(one ? [element("strong", {}, words.problem), element("p", {}, one.fields[0] ? `${one.fields[0].pointer}: ${one.fields[0].detail}` : one.message), iconButton("close", words.dismiss, () => (studio.problem.value = null))] : []));
    }));
    const notice = bringNotice(this.bring.message);
    const brought = broughtLabel(studio, this.bring);
    const drop = new DropTarget(words.dropHere, (file) => void this.bring.open(file));
    this.endings.push(notice.end, brought.end, () => drop.dispose());
    return element("section", { className: "stage-area" }, stage.viewport.element, views, hint, labels, away, problem, brought.element, notice.element, drop.element);
  }

  private panelArea(): HTMLElement {
    const { studio, words } = this;
    const heading = element("h2", {});
    const area = element("aside", { className: "panel", aria: { label: words.resizePanel } }, heading);
    this.endings.push(studio.mode.follow((mode) => {
      this.panel?.dispose();
      this.panel = this.panelOf(mode);
      heading.textContent = words.modeNames[mode];
      area.replaceChildren(heading, this.panel.element);
    }));
    this.endings.push(() => this.panel?.dispose());
    return area;
  }

  private panelOf(mode: Mode): Panel {
    const words = panelText[language.value];
    this.fields.clear();
    if (mode === "draw") return new DrawPanel(this.studio, words, this.fields);
    if (mode === "shape") return new ShapePanel(this.studio, words, this.fields);
    if (mode === "fill") return new FillPanel(this.studio, this.preview, words, this.fields);
    return new CharacterPanel(this.bring, new MovePanel(this.studio, this.stage.picture, words, this.fields));
  }

  private timeline(): HTMLElement {
    const { studio, player, stage } = this;
    const words = motionText[language.value];
    const transport = (this.transport = new Transport(words));
    const sheet = new ExposureSheet(words);
    const show = () => {
      transport.setPlaying(player.playing);
      sheet.showFrame(player.frame);
      stage.viewport.invalidate();
    };
    const after = (act: () => void) => () => {
      act();
      show();
    };
    Object.assign(transport, {
      onFirst: after(() => player.seek(0)),
      onPrevious: after(() => player.stepPicture(-1)),
      onNext: after(() => player.stepPicture(1)),
      onToggle: after(() => player.toggle()),
      onOnion: (isOn: boolean) => (studio.isOnion.value = isOn),
      onCompare: (isOn: boolean) => (studio.compares.value = isOn),
    });
    sheet.onSeek = (frame) => after(() => player.seek(frame))();
    const bar = element("footer", { className: "timeline" }, transport.element, sheet.element);
    this.endings.push(
      studio.isOnion.follow((isOn) => transport.setOnion(isOn)),
      studio.compares.follow((isOn) => transport.setCompare(isOn)),
      studio.loader.schedule.follow((schedule) => sheet.update(schedule)),
      stage.frame.follow(show),
      studio.mode.follow((mode) => {
        bar.hidden = mode !== "move";
        // Whoever wishes for less motion starts it by hand.
        if (mode === "move" && !player.playing && !matchMedia("(prefers-reduced-motion: reduce)").matches) player.play();
        if (mode !== "move") player.pause();
        show();
      }),
      () => sheet.dispose(),
    );
    return bar;
  }
}
