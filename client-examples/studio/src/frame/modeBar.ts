import type { App } from "../App";
import { element } from "../base/element";
import type { Part } from "../base/Part";
import { kModes } from "../Studio";
import { iconButton } from "../widgets/iconButton";

/** What one does with the pointer: draw, shape, fill, or let move. */
export function modeBar({ studio, words }: App): Part {
  const buttons = kModes.map((mode, i) => iconButton(mode, words.modeNames[mode], () => (studio.mode.value = mode), { shows_name: true, shortcut: String(i + 1), className: "mode" }));
  const dispose = studio.mode.follow((current) => buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(kModes[i] === current))));
  return { element: element("nav", { className: "mode-bar", aria: { label: words.modes } }, ...buttons), dispose };
}
