import { element } from "../base/element";
import type { Part } from "../base/Part";
import { changeTufts } from "../model/changeTufts";
import type { Studio } from "../Studio";
import type { panelText } from "../text/panelText";
import type { Fields } from "./Fields";
import { TuftFields } from "./TuftFields";
import { TuftList } from "./TuftList";

/** The selected tufts' shape, and the list of all. */
export class ShapePanel implements Part {
  readonly element: HTMLElement;
  private readonly endings: (() => void)[];

  constructor(studio: Studio, words: typeof panelText.en, fields: Fields) {
    const shape = new TuftFields(words, fields,
      (change, field) => studio.edit((document) => changeTufts(document, studio.selection.value, (tuft) => ({ ...tuft, ...change })), `${field} of ${studio.selection.value.join()}`),
      () => studio.history.settle());
    const list = new TuftList(studio, words);
    const heading = element("h3", {});
    const chosen = element("section", { className: "group" }, heading, shape.element);
    this.element = element("div", { className: "panel-body" }, element("p", { className: "help" }, words.shapeHelp), chosen, list.element);
    const show = () => {
      const { selected } = studio;
      const last = selected.at(-1);
      heading.textContent = last ? words.selected(selected.length) : words.nothingSelected;
      shape.element.hidden = !last;
      if (last) shape.set(last);
    };
    this.endings = [studio.selection.changed(show), studio.history.current.changed(show), () => list.dispose()];
    show();
  }

  dispose(): void {
    for (const end of this.endings) end();
  }
}
