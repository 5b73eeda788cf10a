import type { CharacterChain } from "../api/contract";
import { ServiceProblem } from "../api/ServiceProblem";
import { element } from "../base/element";
import type { Bringing } from "../bring/Bringing";
import type { Part } from "../base/Part";
import { bringText } from "../text/bringText";
import { language } from "../text/language";
import { group } from "../widgets/group";
import type { BroughtCharacter } from "./BroughtCharacter";
import { download } from "../take_away/download";

const kKinds = ["hair", "ribbon", "skirt", "unknown"] as const;

/** Above the panel of motion: which chains of a character move, and what can be done with it. Without a character, nothing. */
export class CharacterPanel implements Part {
  readonly element: HTMLElement;
  private readonly words = bringText[language.value];
  private readonly place = element("div", { className: "panel-body" });
  private readonly nothing = element("p", { className: "help", role: "status" }, this.words.nothingMoves);
  private readonly take = element("button", { type: "button", className: "primary", onclick: () => void this.download() }, this.words.takeCharacter);
  private readonly end: () => void;
  private shown: readonly CharacterChain[] | null = null;
  private boxes: { readonly input: HTMLInputElement; readonly indices: readonly number[] }[] = [];

  constructor(private readonly bringing: Bringing, private readonly inner: Part) {
    this.element = element("div", { className: "panel-body character-panel" }, this.place, inner.element);
    this.end = bringing.guest.character.follow((character) => this.show(character));
  }

  dispose(): void {
    this.end();
    this.inner.dispose();
  }

  private show(character: BroughtCharacter | null): void {
    this.place.hidden = character === null;
    if (this.shown !== (character?.found.chains ?? null)) this.build(character);
    const chosen = new Set(character?.chosen);
    this.take.disabled = chosen.size === 0;
    this.nothing.hidden = chosen.size > 0;
    for (const { input, indices } of this.boxes) {
      const count = indices.filter((index) => chosen.has(index)).length;
      input.checked = count === indices.length;
      input.indeterminate = count > 0 && count < indices.length;
    }
  }

  private build(character: BroughtCharacter | null): void {
    const { words } = this;
    this.shown = character?.found.chains ?? null;
    this.boxes = [];
    if (!character) return this.place.replaceChildren();
    const kinds = kKinds.flatMap((kind) => {
      const chains = character.found.chains.filter((chain) => chain.kind === kind);
      return chains.length > 0 ? [this.kind(words.kinds[kind], chains)] : [];
    });
    this.place.replaceChildren(group(words.character,
      element("p", { className: "help" }, words.characterHelp), ...kinds, this.nothing,
      element("div", { className: "chain-actions" }, this.take,
        element("button", { type: "button", className: "plain", onclick: () => void this.bringing.drawOnCharacter() }, words.drawOnIt),
        element("button", { type: "button", className: "plain", onclick: () => this.bringing.backToBundledHead() }, words.bundledHead))));
  }

  private kind(name: string, chains: readonly CharacterChain[]): HTMLElement {
    const { words } = this;
    const bones = chains.reduce((sum, chain) => sum + chain.bones.length, 0);
    const rows = chains.map((chain) => element("li", {}, this.box(chain.name || words.unnamed(chain.index), [chain.index], words.bones(chain.bones.length))));
    return element("div", { className: "chain-kind" }, this.box(name, chains.map(({ index }) => index)),
      element("details", {}, element("summary", { className: "help" }, words.chains(chains.length, bones)), element("ul", { className: "chain-list" }, ...rows)));
  }

  private box(label: string, indices: readonly number[], hint = ""): HTMLElement {
    const input = element("input", {
      type: "checkbox",
      onchange: () => {
        const chosen = this.bringing.guest.character.value?.chosen ?? [];
        const left = chosen.filter((index) => !indices.includes(index));
        this.bringing.guest.choose(input.checked ? [...left, ...indices].sort((a, b) => a - b) : left);
      },
    });
    this.boxes.push({ input, indices });
    return element("label", { className: "toggle", title: hint ? `${label}: ${hint}` : label }, input, element("span", {}, label));
  }

  private async download(): Promise<void> {
    const character = this.bringing.guest.character.value;
    if (!character) return;
    this.take.disabled = true;
    this.take.textContent = this.words.taking;
    try {
      download(character.name, await this.bringing.guest.file(), "application/octet-stream");
    } catch (error) {
      const { name } = character;
      this.bringing.message.value = error instanceof ServiceProblem ? { kind: "refused", name, problem: error } : { kind: "away", name };
    }
    this.take.disabled = false;
    this.take.textContent = this.words.takeCharacter;
  }
}
