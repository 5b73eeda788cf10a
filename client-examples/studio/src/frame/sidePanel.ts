import type { App } from "../App";
import { element } from "../base/element";
import type { Part } from "../base/Part";
import { CharacterPanel } from "../character/CharacterPanel";
import { DrawPanel } from "../panels/DrawPanel";
import { FillPanel } from "../panels/FillPanel";
import { MovePanel } from "../panels/MovePanel";
import { ShapePanel } from "../panels/ShapePanel";
import type { Mode } from "../Studio";
import { language } from "../text/language";
import { panelText } from "../text/panelText";

function panelOf(mode: Mode, { studio, fields, preview, stage, bring }: App): Part {
  const words = panelText[language.value];
  if (mode === "draw") return new DrawPanel(studio, words, fields);
  if (mode === "shape") return new ShapePanel(studio, words, fields);
  if (mode === "fill") return new FillPanel(studio, preview, words, fields);
  return new CharacterPanel(bring, new MovePanel(studio, stage.picture, words, fields));
}

/** The settings of the mode. */
export function sidePanel(app: App): Part {
  const { studio, words, fields } = app;
  const heading = element("h2", {});
  const area = element("aside", { className: "panel", aria: { label: words.settings } }, heading);
  let panel: Part | null = null;
  const end = studio.mode.follow((mode) => {
    panel?.dispose();
    fields.clear();
    panel = panelOf(mode, app);
    heading.textContent = words.modeNames[mode];
    area.replaceChildren(heading, panel.element);
    area.scrollTop = 0;
    fields.announce();
  });
  return {
    element: area,
    dispose: () => {
      end();
      panel?.dispose();
    },
  };
}
