import type { CharacterChainsAnswer } from "../api/contract";
import { ServiceAway } from "../api/ServiceAway";
import { ServiceProblem } from "../api/ServiceProblem";
import { Signal } from "../base/Signal";
import type { BroughtCharacter } from "../character/BroughtCharacter";
import { CharacterGuest } from "../character/CharacterGuest";
import { firstChosen } from "../character/firstChosen";
import { FileStore } from "../keep/FileStore";
import type { HeadBall } from "../model/HeadBall";
import { newDocument } from "../model/newDocument";
import type { StudioDocument } from "../model/StudioDocument";
import type { HairStage } from "../stage/HairStage";
import type { Studio } from "../Studio";
import type { BringMessage } from "./BringMessage";
import type { BroughtHead } from "./BroughtHead";
import { headBall } from "./headBall";
import { headOf } from "./headOf";
import { HeadShelf } from "./HeadShelf";
import { kindOfFile } from "./kindOfFile";
import { openHairstyle } from "./openHairstyle";
import { paintBytes } from "./paintBytes";

/** Files that a person brings: hairstyles are opened, heads are put under the hair, characters are shown. */
export class Bringing {
  /** What is to be said about the last file. */
  readonly message = new Signal<BringMessage | null>(null);
  readonly heads: HeadShelf;
  readonly guest: CharacterGuest;
  private readonly files = new FileStore();
  private running: AbortController | null = null;

  constructor(private readonly studio: Studio, stage: HairStage) {
    this.heads = new HeadShelf(studio, stage);
    this.guest = new CharacterGuest(studio, stage);
    this.guest.character.changed((character) => void this.keep("character", character));
    this.heads.shown.changed((head) => void this.keep("head", head));
  }

  /** Opens a file, whatever it is; what is there stays as it is if that fails. The last one that is opened wins. */
  async open(file: File): Promise<void> {
    this.running?.abort();
    const running = new AbortController();
    this.running = running;
    const { name } = file;
    this.message.value = { kind: "opening", name };
    const message = await this.read(file, running.signal).catch((error: unknown): BringMessage => {
      if (error instanceof ServiceProblem) return { kind: "refused", name, problem: error };
      if (error instanceof ServiceAway) return { kind: "away", name };
      if (error instanceof RangeError) return { kind: "empty", name };
      return { kind: "unshown", name };
    });
    const isAnswered = message === null && this.message.value?.kind !== "opening"; // it could not be kept, say
    if (!running.signal.aborted && !isAnswered) this.message.value = message;
  }

  /** Brings back what was there before a reload. */
  async restore(): Promise<void> {
    const head = await this.files.get<BroughtHead>("head");
    if (head) {
      this.heads.add(head);
      this.heads.follow();
    }
    const character = await this.files.get<BroughtCharacter>("character");
    if (!character) return;
    const isThere = await this.guest.welcome(character).catch(() => false);
    if (!isThere) await this.files.put("character", null);
    else if (this.studio.document.tufts.length === 0) this.studio.mode.value = "move"; // else hair was being drawn
  }

  /** The character becomes the head to draw on. */
  async drawOnCharacter(): Promise<void> {
    const character = this.guest.character.value;
    if (!character) return;
    try {
      await this.wear(character.name, character.bytes, character.found);
    } catch {
      this.message.value = { kind: "empty", name: character.name };
      return;
    }
    this.guest.leave();
    this.studio.mode.value = "draw";
  }

  /** Takes away what came as a file: the character and the head; hair moves to the bundled one. */
  backToBundledHead(): void {
    this.guest.leave();
    if (this.heads.shown.value) this.heads.wear(null);
  }

  /** A new document, on the head that is shown. */
  begin(): void {
    this.guest.leave();
    const shown = this.heads.shown.value;
    this.studio.edit(() => (shown ? { ...newDocument(), head: shown.head } : newDocument()));
  }

  /** A document that comes from elsewhere, as one step; a character makes room for it. */
  show(document: StudioDocument): void {
    this.guest.leave();
    this.studio.edit(() => document);
  }

  private async keep(place: string, file: { readonly name: string } | null): Promise<void> {
    const isKept = await this.files.put(place, file);
    if (!isKept && file) this.message.value = { kind: "notKept", name: file.name };
  }

  private async read(file: File, signal: AbortSignal): Promise<BringMessage | null> {
    const { name } = file;
    const bytes = await file.arrayBuffer();
    const found = kindOfFile(bytes);
    if (found.kind === "cut") return { kind: "cut", name };
    if (found.kind === "unknown") return { kind: "unread", name };
    if (found.kind === "hairstyle") {
      const document = await openHairstyle(this.studio.service, found.hairstyle, name.replace(/\.[^.]*$/, ""), signal);
      signal.throwIfAborted();
      this.show(document);
      return null;
    }
    const answer = await this.studio.service.json<CharacterChainsAnswer>("/v1/characters/chains", { body: bytes, signal });
    if (answer.chains.length > 0) {
      const isThere = await this.guest.welcome({ name, bytes, found: answer, chosen: firstChosen(answer) }, signal);
      if (isThere) this.studio.mode.value = "move";
    } else {
      await this.wear(name, bytes, answer, signal);
      if (!signal.aborted) this.guest.leave();
    }
    return null;
  }

  /** Puts what is in a file under the hair. */
  private async wear(name: string, bytes: ArrayBuffer, { facing, head: known }: CharacterChainsAnswer, signal?: AbortSignal): Promise<void> {
    let ball: HeadBall = { center: [0, 0, 0], radius: 1 };
    const painted = await paintBytes(bytes, (corners) => (ball = headBall(corners, known?.center ?? null)));
    if (signal?.aborted) return painted.dispose();
    const brought = { name, bytes, ball, head: headOf(ball, facing) };
    this.heads.add(brought, painted);
    this.heads.wear(brought);
  }
}
