import { element } from "../base/element";

/** A color, with the ones that hair often has beside it. */
export function colorField(label: string, swatches: readonly string[], onInput: (color: string) => void, onSettle: () => void): { readonly element: HTMLElement; set(color: string): void } {
  const input = element("input", { type: "color", oninput: () => onInput(input.value), onchange: onSettle });
  const buttons = swatches.map((color) => {
    const button = element("button", { type: "button", className: "swatch", title: color, aria: { label: `${label} ${color}` }, onclick: () => { onInput(color); onSettle(); } });
    button.style.setProperty("--swatch", color);
    return button;
  });
  return {
    element: element("div", { className: "color-field" }, element("label", {}, element("span", {}, label), input), element("div", { className: "swatches" }, ...buttons)),
    set: (color) => (input.value = color),
  };
}
