import { Signal } from "../base/Signal";

export type Language = "en" | "ja";

const kKey = "tuftwave.language";

function preferred(): Language {
  const kept = localStorage.getItem(kKey);
  if (kept === "en" || kept === "ja") return kept;
  return navigator.language.startsWith("ja") ? "ja" : "en";
}

/** The language of the page: what was chosen last, else the browser's. */
export const language = new Signal<Language>(preferred());

language.follow((chosen) => {
  document.documentElement.lang = chosen;
  localStorage.setItem(kKey, chosen);
});
