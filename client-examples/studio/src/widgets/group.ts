import { element } from "../base/element";

/** A part of a panel under its heading. */
export function group(heading: string, ...children: (Node | string | null | false)[]): HTMLElement {
  return element("section", { className: "group" }, element("h3", {}, heading), ...children);
}
