import { element } from "../base/element";
import { bringText } from "../text/bringText";
import { language } from "../text/language";
import type { Bringing } from "./Bringing";

/** Names the head that came as a file, and takes it away again. @return  the element, and what ends it */
export function broughtLabel(bringing: Bringing): { readonly element: HTMLElement; readonly end: () => void } {
  const words = bringText[language.value];
  const name = element("span", {});
  const label = element("div", { className: "brought" }, name, element("button", { type: "button", className: "plain", onclick: () => bringing.heads.wear(null) }, words.bundledHead));
  const end = bringing.heads.shown.follow((head) => {
    label.hidden = head === null;
    name.textContent = name.title = head ? words.headOf(head.name) : "";
  });
  return { element: label, end };
}
