import type { CharacterChainsAnswer } from "../api/contract";

/** A character that came as a file, and what the service found in it. */
export interface BroughtCharacter {
  readonly name: string;
  readonly bytes: ArrayBuffer;
  readonly found: CharacterChainsAnswer;
  /** Indices of the chains that move. */
  readonly chosen: readonly number[];
}
