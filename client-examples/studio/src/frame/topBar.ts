import type { App } from "../App";
import { element } from "../base/element";
import type { Part } from "../base/Part";
import { theme, type Theme } from "../base/theme";
import { openButton } from "../bring/openButton";
import { GalleryDialog } from "../gallery/GalleryDialog";
import { language } from "../text/language";
import { iconButton } from "../widgets/iconButton";

const kThemes: readonly Theme[] = ["system", "light", "dark"];

/** The name of the document, what one does with it as a whole, and how the page looks. */
export function topBar(app: App): Part {
  const { studio, words } = app;
  const { history } = studio;
  const name = element("input", {
    type: "text", className: "document-name", maxLength: 60, aria: { label: words.documentName },
    oninput: () => studio.edit((document) => ({ ...document, name: name.value }), "name"),
    onchange: () => history.settle(),
  });
  const undo = iconButton("undo", words.undo, () => history.undo(), { shortcut: "Ctrl+Z" });
  const redo = iconButton("redo", words.redo, () => history.redo(), { shortcut: "Ctrl+Shift+Z" });
  const other = language.value === "en" ? "ja" : "en";
  const bar = element("header", { className: "top-bar" },
    element("h1", {}, "Tuftwave"), name,
    element("div", { className: "bar-group" }, undo, redo),
    element("div", { className: "bar-group" },
      iconButton("fresh", words.fresh, () => app.bring.begin(), { shows_name: true }),
      iconButton("gallery", words.gallery, () => new GalleryDialog(studio, (document) => app.bring.show(document)).show(), { shows_name: true }),
      openButton(words.open, (file) => void app.bring.open(file)),
      iconButton("save", words.takeAway, () => app.takeAway(), { shows_name: true, shortcut: "Ctrl+S" })),
    element("div", { className: "bar-group bar-end" },
      iconButton("help", words.help, () => app.help(), { shortcut: "?" }),
      iconButton("sun", words.theme, () => (theme.value = kThemes[(kThemes.indexOf(theme.value) + 1) % kThemes.length]!)),
      element("button", { type: "button", className: "plain", lang: other, onclick: () => (language.value = other) }, words.language)));
  const dispose = history.current.follow((document) => {
    if (name.value !== document.name) name.value = document.name;
    undo.disabled = !history.canUndo;
    redo.disabled = !history.canRedo;
  });
  return { element: bar, dispose };
}
