import { Signal } from "../base/Signal";
import { kept } from "../keep/kept";

export type Language = "en" | "ja";

const kChoice = kept("tuftwave.language");

function preferred(): Language {
  const chosen = kChoice.read();
  if (chosen === "en" || chosen === "ja") return chosen;
  return navigator.language.startsWith("ja") ? "ja" : "en";
}

/** The language of the page: what was chosen last, else the browser's. */
export const language = new Signal<Language>(preferred());

language.follow((chosen) => {
  document.documentElement.lang = chosen;
  kChoice.write(chosen);
});
