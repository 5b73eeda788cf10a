import type { CharacterMotionAnswer, Motion } from "../api/contract";
import type { Service } from "../api/Service";
import { ServiceAway } from "../api/ServiceAway";
import { ServiceProblem } from "../api/ServiceProblem";
import { Newest } from "../base/Newest";
import { Signal } from "../base/Signal";
import { smoothTiming } from "../motion/smoothTiming";
import type { BroughtCharacter } from "./BroughtCharacter";
import { motionQuery } from "./motionQuery";

/** A character in motion: as it is held, and at nearly every moment; null is still. */
export interface CharacterPoses {
  readonly limited: CharacterMotionAnswer | null;
  readonly smooth: CharacterMotionAnswer | null;
}

/** Asks the service for the pictures of a character. */
export class CharacterLoader {
  readonly poses = new Signal<CharacterPoses>({ limited: null, smooth: null });
  readonly problem = new Signal<ServiceProblem | null>(null);
  private readonly newest = new Newest();
  private wish: (() => void) | null = null;

  constructor(private readonly service: Service) {
    service.isHere.changed((isHere) => isHere && this.wish?.());
  }

  load(character: BroughtCharacter, motion: Motion, compares: boolean): void {
    this.wish = () => this.newest.start((signal) => this.answer(character, motion, compares, signal));
    this.wish();
  }

  /** There is no character any more. */
  clear(): void {
    this.wish = null;
    this.newest.start(async () => {
      this.poses.value = { limited: null, smooth: null };
    });
  }

  /** The same file with the clip in it. @throws as Service does */
  file({ bytes, found, chosen }: BroughtCharacter, motion: Motion): Promise<ArrayBuffer> {
    return this.service.bytes("/v1/characters/motion", { body: bytes, query: motionQuery(motion, found.chains, chosen, found.head !== null) });
  }

  private async answer(character: BroughtCharacter, motion: Motion, compares: boolean, signal: AbortSignal): Promise<void> {
    try {
      const ask = (wanted: Motion) => this.ask(character, wanted, signal);
      const [limited, smooth] = await Promise.all([ask(motion), compares ? ask({ ...motion, timing: smoothTiming(motion.timing ?? {}) }) : null]);
      this.poses.value = { limited, smooth };
      this.problem.value = null;
    } catch (error) {
      if (signal.aborted) throw error;
      if (error instanceof ServiceProblem) this.problem.value = error;
      else if (!(error instanceof ServiceAway)) throw error;
    }
  }

  private async ask({ bytes, found, chosen }: BroughtCharacter, motion: Motion, signal: AbortSignal): Promise<CharacterMotionAnswer | null> {
    if (chosen.length === 0) return null;
    const query = { format: "json", ...motionQuery(motion, found.chains, chosen, found.head !== null) };
    return this.service.json<CharacterMotionAnswer>("/v1/characters/motion", { body: bytes, query, signal });
  }
}
