import { element } from "../base/element";
import { iconButton } from "./iconButton";

const kDice = 10000; // seeds that people can read out to each other

/** A seed, and a dice for another. */
export function seedField(label: string, dice: string, onChange: (seed: number) => void): { readonly element: HTMLElement; set(seed: number): void } {
  const input = element("input", { type: "number", min: "0", step: "1", oninput: () => Number.isInteger(input.valueAsNumber) && onChange(input.valueAsNumber) });
  const roll = iconButton("dice", dice, () => {
    input.value = String(Math.floor(Math.random() * kDice));
    onChange(Number(input.value));
  });
  return {
    element: element("div", { className: "seed-field" }, element("label", {}, element("span", {}, label), input), roll),
    set: (seed) => document.activeElement !== input && (input.value = String(seed)),
  };
}
