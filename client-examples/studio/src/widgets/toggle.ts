import { element } from "../base/element";

export interface Toggle {
  readonly element: HTMLElement;
  set(value: boolean): void;
}

/** A checkbox with its label. */
export function toggle(label: string, onChange: (value: boolean) => void, hint = ""): Toggle {
  const input = element("input", { type: "checkbox", onchange: () => onChange(input.checked) });
  return { element: element("label", { className: "toggle", title: hint }, input, element("span", {}, label)), set: (value) => (input.checked = value) };
}
