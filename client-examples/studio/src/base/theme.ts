import { Signal } from "./Signal";

export type Theme = "system" | "light" | "dark";

const kKey = "tuftwave.theme";
const kThemes: readonly Theme[] = ["system", "light", "dark"];

/** Light or dark, as chosen last, else as the system says. */
export const theme = new Signal<Theme>(kThemes.find((one) => one === localStorage.getItem(kKey)) ?? "system");

theme.follow((chosen) => {
  document.documentElement.dataset.theme = chosen;
  localStorage.setItem(kKey, chosen);
});
