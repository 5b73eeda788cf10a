import type { App } from "../App";
import { element } from "../base/element";
import type { Part } from "../base/Part";
import { bringNotice } from "../bring/bringNotice";
import { broughtLabel } from "../bring/broughtLabel";
import { DropTarget } from "../bring/DropTarget";
import { kViews, type View } from "../stage/Viewport";
import { problemNote } from "./problemNote";

/** The picture, and what is said over it. */
export function stageArea(app: App): Part {
  const { studio, words, stage, bring, autosave } = app;
  const views = element("div", { className: "view-bar", role: "group", aria: { label: words.views } },
    ...(Object.keys(kViews) as View[]).map((view) => element("button", { type: "button", onclick: () => stage.viewport.look(view) }, words.viewNames[view])));
  const hint = element("p", { className: "stage-hint" });
  const labels = element("div", { className: "compare-labels" }, element("span", {}, words.limited), element("span", {}, words.smooth));
  const away = element("p", { className: "stage-away", role: "status" });
  const show = () => {
    const moves = studio.mode.value === "move";
    const isEmpty = studio.document.tufts.length === 0 && studio.drawn.value === null && !stage.draw.isClicking && !(moves && bring.guest.character.value);
    hint.hidden = !isEmpty;
    hint.textContent = !isEmpty ? "" : studio.mode.value === "draw" ? words.hintEmpty : words.hintMove;
    labels.hidden = !(moves && studio.compares.value);
    away.textContent = !studio.service.isHere.value ? words.away : !autosave.isKept.value ? words.notSaved : "";
    away.hidden = away.textContent === "";
  };
  const signals = [studio.history.current, studio.mode, studio.drawn, studio.compares, studio.service.isHere, autosave.isKept, bring.guest.character];
  const endings = signals.map((signal) => signal.changed(show));
  show();
  const problem = problemNote(app);
  const notice = bringNotice(bring.message);
  const brought = broughtLabel(studio, bring);
  const drop = new DropTarget(words.dropHere, (file) => void bring.open(file));
  return {
    element: element("section", { className: "stage-area" }, stage.viewport.element, views, hint, labels, away, problem.element, brought.element, notice.element, drop.element),
    dispose: () => [...endings, problem.dispose, notice.end, brought.end, () => drop.dispose()].forEach((end) => end()),
  };
}
