import { element } from "../base/element";

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer?.types.includes("Files") ?? false;
}

/** The whole page takes files that are dropped, and says so while one is dragged over it. */
export class DropTarget {
  readonly element = element("div", { className: "drop-target", hidden: true });
  private readonly ending = new AbortController();

  constructor(words: string, onFile: (file: File) => void) {
    this.element.append(element("p", {}, words));
    const { signal } = this.ending;
    window.addEventListener("dragover", (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      if (event.dataTransfer) event.dataTransfer.dropEffect = "copy";
      this.element.hidden = false;
    }, { signal });
    // Left for another element it goes on; left for nothing it is out of the window.
    window.addEventListener("dragleave", (event) => event.relatedTarget === null && this.hide(), { signal });
    window.addEventListener("drop", (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      this.hide();
      const file = event.dataTransfer?.files[0];
      if (file) onFile(file);
    }, { signal });
  }

  dispose(): void {
    this.ending.abort();
  }

  private hide(): void {
    this.element.hidden = true;
  }
}
