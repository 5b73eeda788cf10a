import type { Head, Motion, Tuft } from "../api/contract";

/** A tuft that keeps its identity while it is renamed, moved in the list or drawn anew. */
export interface StudioTuft extends Tuft {
  readonly id: number;
}

/** What is drawn, saved, undone and redone. Never changed in place: every edit gives a new one. */
export interface StudioDocument {
  readonly name: string;
  readonly head: Head;
  /** Color of the hair, #rrggbb. */
  readonly color: string;
  readonly tufts: readonly StudioTuft[];
  readonly motion: Motion;
}
