import { element } from "../base/element";
import type { Studio } from "../Studio";
import { bringText } from "../text/bringText";
import { language } from "../text/language";
import { iconButton } from "../widgets/iconButton";
import type { Bringing } from "./Bringing";

/** Names the head or the character that came as a file, and takes it away again. @return  the element, and what ends it */
export function broughtLabel(studio: Studio, bringing: Bringing): { readonly element: HTMLElement; readonly end: () => void } {
  const words = bringText[language.value];
  const name = element("span", {});
  const label = element("div", { className: "brought" }, name, iconButton("close", words.bundledHead, () => bringing.backToBundledHead()));
  const show = () => {
    const [head, character] = [bringing.heads.shown.value, studio.mode.value === "move" ? bringing.guest.character.value : null];
    label.hidden = head === null && character === null;
    name.textContent = name.title = character ? words.characterOf(character.name) : head ? words.headOf(head.name) : "";
  };
  const ends = [bringing.heads.shown.changed(show), bringing.guest.character.changed(show), studio.mode.changed(show)];
  show();
  return { element: label, end: () => ends.forEach((end) => end()) };
}
