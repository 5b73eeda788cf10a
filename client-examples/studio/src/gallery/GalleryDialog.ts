import { element } from "../base/element";
import { fromHairstyle } from "../model/fromHairstyle";
import type { StudioDocument } from "../model/StudioDocument";
import type { Studio } from "../Studio";
import { galleryText } from "../text/galleryText";
import { language } from "../text/language";
import { Dialog } from "../widgets/Dialog";
import { gallery, type GalleryEntry } from "./gallery";
import "./gallery.css";

/** Cards with the ready hairstyles. A click opens one, in one step that can be undone. */
export class GalleryDialog {
  private readonly words = galleryText[language.value];
  private readonly dialog: Dialog;

  /** @param onOpen  takes the hairstyle that was picked */
  constructor(private readonly studio: Studio, private readonly onOpen: (document: StudioDocument) => void) {
    const cards = element("ul", { className: "gallery-cards" }, ...gallery.map((entry) => element("li", {}, this.card(entry))));
    this.dialog = new Dialog(this.words.title, this.words.close, element("p", { className: "help" }, this.words.help), cards);
    this.dialog.element.classList.add("gallery-dialog");
  }

  show(): void {
    this.dialog.show();
  }

  private card(entry: GalleryEntry): HTMLButtonElement {
    const { words } = this;
    const { tufts, motion } = entry.hairstyle;
    const { period = 0, hold = 2 } = motion?.timing ?? {};
    return element("button", { type: "button", className: "gallery-card", onclick: () => this.open(entry) },
      element("img", { src: entry.picture, alt: words.pictures[entry.name], width: 240, height: 280 }),
      element("strong", {}, words.names[entry.name]),
      element("span", {}, words.tufts(tufts.length)),
      element("span", {}, words.motion(String(period), hold as 1 | 2 | 3)));
  }

  private open({ name, hairstyle }: GalleryEntry): void {
    this.studio.select([]);
    this.onOpen(fromHairstyle(hairstyle, this.words.names[name]));
    this.dialog.close();
  }
}
