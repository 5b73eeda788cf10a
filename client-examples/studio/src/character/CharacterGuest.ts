import { Signal } from "../base/Signal";
import type { HairStage } from "../stage/HairStage";
import type { Studio } from "../Studio";
import type { BroughtCharacter } from "./BroughtCharacter";
import { CharacterLoader } from "./CharacterLoader";
import { CharacterView } from "./CharacterView";

/** The character of this visit: shown in the mode "move", moved as the document's motion says. */
export class CharacterGuest {
  readonly character = new Signal<BroughtCharacter | null>(null);
  readonly loader: CharacterLoader;
  private view: CharacterView | null = null;

  constructor(private readonly studio: Studio, private readonly stage: HairStage) {
    this.loader = new CharacterLoader(studio.service);
    this.loader.poses.changed((poses) => {
      this.view?.setPoses(poses);
      stage.viewport.invalidate();
    });
    this.loader.problem.changed((problem) => (studio.problem.value = problem));
    for (const signal of [studio.history.current, studio.mode, studio.compares]) signal.changed(() => this.load());
  }

  /**
   * Takes a character in.
   * @return  whether it is there: not if `signal` said meanwhile that it is not wanted any more
   * @throws as CharacterView.load does; then all stays as it is
   */
  async welcome(character: BroughtCharacter, signal?: AbortSignal): Promise<boolean> {
    const view = await CharacterView.load(character);
    if (signal?.aborted) {
      view.dispose();
      return false;
    }
    this.show(view);
    this.character.value = character;
    this.load();
    return true;
  }

  /** Takes the character away. */
  leave(): void {
    if (!this.character.value) return;
    this.character.value = null;
    this.loader.clear();
    this.show(null);
  }

  /** @param chosen  indices of the chains that move */
  choose(chosen: readonly number[]): void {
    const character = this.character.value;
    if (!character) return;
    this.character.value = { ...character, chosen };
    this.load();
  }

  /** The character's file with the clip in it. @throws as Service does */
  async file(): Promise<ArrayBuffer> {
    const character = this.character.value;
    if (!character) throw new Error("there is no character");
    return this.loader.file(character, this.studio.document.motion);
  }

  private show(view: CharacterView | null): void {
    this.stage.setGuest(view);
    this.view?.dispose();
    this.view = view;
  }

  private load(): void {
    const character = this.character.value;
    if (character && this.studio.mode.value === "move") this.loader.load(character, this.studio.document.motion, this.studio.compares.value);
  }
}
