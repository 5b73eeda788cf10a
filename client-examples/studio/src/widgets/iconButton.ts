import { element } from "../base/element";
import { icon, type IconName } from "./icon";

/** A button with an icon, and with its name beside it if `shows_name`. `shortcut` stands in its tip. */
export function iconButton(name: IconName, label: string, onclick: () => void, { shortcut = "", shows_name = false, className = "" } = {}): HTMLButtonElement {
  const button = element("button", { type: "button", className: `icon-button ${className}`, title: shortcut ? `${label} (${shortcut})` : label, onclick }, shows_name && element("span", {}, label));
  if (!shows_name) button.setAttribute("aria-label", label);
  button.prepend(icon(name));
  return button;
}
