import { element } from "../base/element";

export interface Choice<T extends string> {
  readonly element: HTMLElement;
  set(value: T): void;
}

let made = 0;

/** A row of buttons of which one is pressed: radio buttons, dressed up. */
export function choice<T extends string>(label: string, options: readonly (readonly [T, string])[], onChoose: (value: T) => void): Choice<T> {
  const name = `choice-${++made}`;
  const inputs = options.map(([value, text]) => {
    const input = element("input", { type: "radio", name, value, onchange: () => onChoose(value) });
    return { value, input, label: element("label", {}, input, element("span", {}, text)) };
  });
  return {
    element: element("fieldset", { className: "choice" }, element("legend", {}, label), element("div", { className: "choice-row" }, ...inputs.map((one) => one.label))),
    set: (value) => inputs.forEach((one) => (one.input.checked = one.value === value)),
  };
}
