import { kept } from "../keep/kept";
import { Signal } from "./Signal";

export type Theme = "system" | "light" | "dark";

const kThemes: readonly Theme[] = ["system", "light", "dark"];
const kChoice = kept("tuftwave.theme");
const kDark = matchMedia("(prefers-color-scheme: dark)");

/** Light or dark, as chosen last, else as the system says. */
export const theme = new Signal<Theme>(kThemes.find((one) => one === kChoice.read()) ?? "system");

function show(): void {
  const chosen = theme.value;
  document.documentElement.dataset.theme = chosen === "system" ? (kDark.matches ? "dark" : "light") : chosen;
}

theme.follow((chosen) => {
  kChoice.write(chosen);
  show();
});
kDark.addEventListener("change", show);
