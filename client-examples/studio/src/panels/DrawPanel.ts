import { element } from "../base/element";
import type { Part } from "../base/Part";
import type { Studio } from "../Studio";
import type { panelText } from "../text/panelText";
import { hairColors } from "../model/hairColors";
import { choice } from "../widgets/choice";
import { colorField } from "../widgets/colorField";
import { group } from "../widgets/group";
import { toggle } from "../widgets/toggle";
import type { Fields } from "./Fields";
import { TuftFields } from "./TuftFields";

/** How new strokes are drawn and what their tufts are like. */
export class DrawPanel implements Part {
  readonly element: HTMLElement;
  private readonly endings: (() => void)[];

  constructor(studio: Studio, words: typeof panelText.en, fields: Fields) {
    const { pen } = studio;
    const follows = choice(words.follows, [["head", words.followsHead], ["plane", words.followsPlane]], (value) => (pen.value = { ...pen.value, follows: value }));
    const mirrors = toggle(words.mirrors, (value) => (pen.value = { ...pen.value, mirrors: value }));
    const shape = new TuftFields(words, fields, (change) => (pen.value = { ...pen.value, shape: { ...pen.value.shape, ...change } }), () => undefined);
    const color = colorField(words.color, hairColors, (value) => studio.edit((document) => ({ ...document, color: value }), "color"), () => studio.history.settle());
    this.element = element("div", { className: "panel-body" },
      element("p", { className: "help" }, words.drawHelp), follows.element, mirrors.element,
      group(words.newTuft, shape.element), group(words.look, color.element), element("p", { className: "help" }, words.planeHelp));
    const showPen = () => {
      follows.set(pen.value.follows);
      mirrors.set(pen.value.mirrors);
      shape.set(pen.value.shape);
    };
    this.endings = [pen.follow(showPen), studio.history.current.follow((document) => color.set(document.color))];
  }

  dispose(): void {
    for (const end of this.endings) end();
  }
}
