import { element } from "../base/element";
import { appText } from "../text/appText";
import { keyText } from "../text/keyText";
import { language } from "../text/language";
import { Dialog } from "../widgets/Dialog";
import { isKey } from "./isKey";
import "./key.css";

/** Asks for a key in a dialog. @return  null if the dialog was closed instead */
export function askForKey(wasRefused: boolean): Promise<string | null> {
  const words = keyText[language.value];
  const fault = element("p", { id: "key-fault", className: "key-fault", role: "alert" }, wasRefused ? words.refused : "");
  const field = element("input", { id: "key-field", type: "password", autocomplete: "off", spellcheck: false, required: true, autofocus: true, aria: { describedby: "key-fault" } });
  const form = element("form", { className: "key-form" },
    element("p", {}, words.why),
    element("label", { htmlFor: field.id }, words.field), field, fault,
    element("button", { type: "submit", className: "icon-button key-send" }, words.send));
  const dialog = new Dialog(words.title, appText[language.value].close, form);
  return new Promise((resolve) => {
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const key = field.value.trim();
      if (!isKey(key)) {
        fault.textContent = words.notAKey;
        field.focus();
        return;
      }
      resolve(key);
      dialog.close();
    });
    dialog.onClose = () => resolve(null); // too late where there is a key already
    dialog.show();
  });
}
