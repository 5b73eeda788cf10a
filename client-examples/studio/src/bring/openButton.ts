import { element } from "../base/element";
import { iconButton } from "../widgets/iconButton";

/** The button that asks for a file. @param label  its name */
export function openButton(label: string, onFile: (file: File) => void): HTMLElement {
  const input = element("input", { type: "file", accept: ".json,.glb,.vrm", hidden: true, className: "open-file", aria: { label } });
  input.addEventListener("change", () => {
    const [file] = input.files ?? [];
    input.value = ""; // so that the same file can be opened again
    if (file) onFile(file);
  });
  return element("span", {}, input, iconButton("open", label, () => input.click(), { shows_name: true }));
}
