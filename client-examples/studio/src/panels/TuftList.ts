import { element } from "../base/element";
import { mirrorTuft } from "../model/mirrorTuft";
import { moveTuft } from "../model/moveTuft";
import { removeTufts } from "../model/removeTufts";
import { renameTuft } from "../model/renameTuft";
import type { StudioTuft } from "../model/StudioDocument";
import type { Studio } from "../Studio";
import type { panelText } from "../text/panelText";
import { iconButton } from "../widgets/iconButton";
import { copySelected } from "./copySelected";

/** All tufts by name, in their order: selected, renamed, moved, duplicated, mirrored, erased. */
export class TuftList {
  readonly element: HTMLElement;
  private readonly heading = element("h3", {});
  private readonly rows = element("ul", { className: "tuft-rows" });
  private readonly tools: HTMLButtonElement[];
  private readonly endings: (() => void)[];
  private renaming: number | null = null;
  private dragged: number | null = null;

  constructor(private readonly studio: Studio, private readonly words: typeof panelText.en) {
    this.tools = [
      iconButton("duplicate", words.duplicate, () => copySelected(studio, (tuft) => tuft), { shortcut: "Ctrl+D" }),
      iconButton("mirror", words.mirror, () => copySelected(studio, (tuft) => mirrorTuft(tuft, studio.document.head)), { shortcut: "M" }),
      iconButton("up", words.moveUp, () => this.move(-1), { shortcut: "Alt+↑" }),
      iconButton("down", words.moveDown, () => this.move(1), { shortcut: "Alt+↓" }),
      iconButton("erase", words.erase, () => studio.edit((document) => removeTufts(document, studio.selection.value)), { shortcut: "Delete" }),
    ];
    this.element = element("section", { className: "group tuft-list" }, element("div", { className: "group-head" }, this.heading, element("div", { className: "row-tools" }, ...this.tools)), this.rows);
    this.endings = [studio.history.current.changed(() => this.show()), studio.selection.changed(() => this.show())];
    this.show();
  }

  dispose(): void {
    for (const end of this.endings) end();
  }

  private move(by: number): void {
    const [id] = this.studio.selection.value;
    const place = this.studio.document.tufts.findIndex((tuft) => tuft.id === id);
    if (id !== undefined) this.studio.edit((document) => moveTuft(document, id, place + by));
  }

  private show(): void {
    const { tufts } = this.studio.document;
    const focused = document.activeElement instanceof HTMLElement && this.rows.contains(document.activeElement) ? document.activeElement.dataset.id : undefined;
    this.heading.textContent = `${this.words.tufts} ${tufts.length}`;
    for (const tool of this.tools) tool.disabled = this.studio.selection.value.length === 0;
    this.rows.replaceChildren(...(tufts.length > 0 ? tufts.map((tuft) => this.row(tuft)) : [element("li", { className: "help" }, this.words.noTufts)]));
    this.rows.querySelector<HTMLElement>(focused ? `[data-id="${focused}"]` : "input")?.focus();
  }

  private row(tuft: StudioTuft): HTMLElement {
    if (this.renaming === tuft.id) return this.nameRow(tuft);
    const isSelected = this.studio.selection.value.includes(tuft.id);
    const button = element("button", {
      type: "button", className: "tuft-name", data: { id: String(tuft.id) }, aria: { pressed: String(isSelected) }, draggable: true,
      onclick: (event) => this.choose(tuft.id, event),
      onkeydown: (event) => this.key(event, tuft.id),
      ondragstart: () => (this.dragged = tuft.id),
    }, tuft.name || "-");
    const row = element("li", { className: isSelected ? "is-selected" : "" }, button);
    row.addEventListener("dragover", (event) => this.dragged !== null && event.preventDefault());
    row.addEventListener("drop", (event) => {
      event.preventDefault();
      const place = this.studio.document.tufts.findIndex(({ id }) => id === tuft.id);
      if (this.dragged !== null) this.studio.edit((old) => moveTuft(old, this.dragged!, place));
      this.dragged = null;
    });
    return row;
  }

  private nameRow(tuft: StudioTuft): HTMLElement {
    const input = element("input", { type: "text", value: tuft.name ?? "", maxLength: 64, aria: { label: this.words.name } });
    const end = (keep: boolean) => {
      if (this.renaming === null) return;
      this.renaming = null;
      if (keep && input.value.trim() && input.value !== tuft.name) this.studio.edit((document) => renameTuft(document, tuft.id, input.value));
      else this.show();
    };
    input.addEventListener("blur", () => end(true));
    input.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key === "Enter") end(true);
      if (event.key === "Escape") end(false);
    });
    return element("li", {}, input);
  }

  private choose(id: number, { shiftKey, ctrlKey, metaKey, detail }: MouseEvent): void {
    const old = this.studio.selection.value;
    if (detail > 1) this.startRenaming(id); // the first click made the row anew, so that none is clicked twice
    else if (ctrlKey || metaKey) this.studio.select(old.includes(id) ? old.filter((one) => one !== id) : [...old, id]);
    else if (shiftKey && old.length > 0) {
      const places = [old[0]!, id].map((one) => this.studio.document.tufts.findIndex((tuft) => tuft.id === one)).sort((a, b) => a - b);
      this.studio.select(this.studio.document.tufts.slice(places[0], places[1]! + 1).map((tuft) => tuft.id));
    } else this.studio.select([id]);
  }

  private startRenaming(id: number): void {
    this.renaming = id;
    this.show();
    this.rows.querySelector("input")?.select();
  }

  private key(event: KeyboardEvent, id: number): void {
    const { tufts } = this.studio.document;
    const place = tufts.findIndex((tuft) => tuft.id === id);
    const step = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (event.key === "F2") this.startRenaming(id);
    else if (step && event.altKey) this.studio.edit((document) => moveTuft(document, id, place + step));
    else if (step) this.rows.querySelector<HTMLElement>(`[data-id="${tufts[place + step]?.id}"]`)?.focus();
    else if (event.key === "Delete") this.studio.edit((document) => removeTufts(document, this.studio.selection.value));
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
