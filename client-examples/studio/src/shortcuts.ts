import type { App } from "./App";
import { mirrorTuft } from "./model/mirrorTuft";
import { copySelected } from "./panels/copySelected";
import { kModes } from "./Studio";


const kPushed: readonly string[] = ["range", "checkbox", "radio", "color"]; // inputs in which nobody writes

/** Keys that work anywhere on the page but where one writes. */
export function shortcuts(event: KeyboardEvent, app: App): void {
  const { studio } = app;
  const writes = event.target instanceof HTMLSelectElement || (event.target instanceof HTMLInputElement && !kPushed.includes(event.target.type));
  const key = event.key.toLowerCase();
  if (event.ctrlKey || event.metaKey) {
    if (key === "z" && event.shiftKey) studio.history.redo();
    else if (key === "z") studio.history.undo();
    else if (key === "y") studio.history.redo();
    else if (key === "o" && !event.shiftKey) app.openFile();
    else if (key === "s" && !event.shiftKey) app.takeAway();
    else if (key === "d" && !writes) copySelected(studio, (tuft) => tuft);
    else return;
    event.preventDefault();
    return;
  }
  if (writes || event.altKey || event.defaultPrevented) return;
  const mode = kModes[Number(key) - 1];
  if (mode) studio.mode.value = mode;
  else if (key === "m") copySelected(studio, (tuft) => mirrorTuft(tuft, studio.document.head));
  else if (key === "?") app.help();
  else if (!app.playbackKey(event)) return;
  event.preventDefault();
}
