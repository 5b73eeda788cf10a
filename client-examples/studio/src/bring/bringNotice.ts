import { element } from "../base/element";
import type { Signal } from "../base/Signal";
import { appText } from "../text/appText";
import { bringText } from "../text/bringText";
import { faultText } from "../text/faultText";
import { language } from "../text/language";
import { iconButton } from "../widgets/iconButton";
import type { BringMessage } from "./BringMessage";

function linesOf(message: BringMessage): string[] {
  const words = bringText[language.value];
  if (message.kind === "unread") return [appText[language.value].notRead(message.name)];
  if (message.kind !== "refused") return [words[message.kind](message.name)];
  const [fault] = message.problem.fields;
  return [words.refused(message.name), fault ? `${fault.pointer}: ${faultText(fault)}` : message.problem.message];
}

/** Says over the picture what became of a file, until it is dismissed. @return  the element, and what ends it */
export function bringNotice(message: Signal<BringMessage | null>): { readonly element: HTMLElement; readonly end: () => void } {
  const notice = element("div", { className: "bring-notice" });
  const end = message.follow((one) => {
    notice.hidden = one === null;
    notice.setAttribute("role", one?.kind === "opening" ? "status" : "alert");
    notice.classList.toggle("is-busy", one?.kind === "opening");
    if (!one) return notice.replaceChildren();
    const [first, ...more] = linesOf(one).map((line, i) => element(i === 0 ? "strong" : "p", {}, line));
    const dismiss = one.kind !== "opening" && iconButton("close", bringText[language.value].dismiss, () => (message.value = null));
    notice.replaceChildren(...[first, ...more, dismiss].filter((child): child is HTMLElement => child instanceof HTMLElement));
  });
  return { element: notice, end };
}
