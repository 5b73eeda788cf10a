import { element } from "../base/element";
import { iconButton } from "./iconButton";
import "./widgets.css";

let made = 0;

/**
 * A dialog over the page. It closes by its button, by Escape and by a press beside it; the focus then returns to where it was.
 * A child with `autofocus` has the focus first, else the close button. Meanwhile the keys of the page do nothing.
 */
export class Dialog {
  readonly element: HTMLDialogElement;
  /** Called whenever it has been closed, however that was. */
  onClose: () => void = () => {};

  constructor(title: string, closeLabel: string, ...children: (Node | string | null | false)[]) {
    const id = `dialog-${++made}`;
    const head = element("header", { className: "dialog-head" }, element("h2", { id }, title), iconButton("close", closeLabel, () => this.close()));
    // The parts lie in a box that fills the dialog: what hits the dialog itself is beside it.
    const box = element("div", { className: "dialog-box" }, head, element("div", { className: "dialog-body" }, ...children));
    this.element = element("dialog", { className: "dialog", aria: { labelledby: id } }, box);
    this.element.addEventListener("pointerdown", ({ target }) => target === this.element && this.close());
    this.element.addEventListener("keydown", (event) => event.stopPropagation());
    this.element.addEventListener("close", () => {
      this.element.remove();
      this.onClose();
    });
  }

  get isOpen(): boolean {
    return this.element.open;
  }

  show(): void {
    if (this.element.open) return;
    document.body.append(this.element);
    this.element.showModal();
  }

  close(): void {
    this.element.close();
  }
}
