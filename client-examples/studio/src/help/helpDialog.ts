import { element } from "../base/element";
import { appText } from "../text/appText";
import { helpText } from "../text/helpText";
import type { Language } from "../text/language";
import { Dialog } from "../widgets/Dialog";
import "./help.css";

/** What one can do and by which keys. */
export function helpDialog(language: Language): Dialog {
  const { title, intro, parts } = helpText[language];
  const tables = parts.map(([heading, rows]) => element("section", {},
    element("h3", {}, heading),
    element("dl", {}, ...rows.flatMap(([keys, does]) => [element("dt", {}, keys), element("dd", {}, does)]))));
  return new Dialog(title, appText[language].close, element("p", {}, intro), element("div", { className: "help-parts" }, ...tables));
}
