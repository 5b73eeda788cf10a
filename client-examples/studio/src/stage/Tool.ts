import type { StagePointer } from "./StagePointer";

/** What the pointer does in one mode. A press that the tool does not take turns the view. */
export interface Tool {
  /** The mode begins or ends. */
  start?(): void;
  stop?(): void;
  /** @return  whether the tool takes this press */
  press?(pointer: StagePointer): boolean;
  /** A press that was taken goes on, `trail` being where it went since the last time, this place included, and ends. */
  drag?(trail: readonly StagePointer[]): void;
  release?(pointer: StagePointer, isClick: boolean): void;
  /** A press that was taken is no longer meant: a second finger came. */
  cancel?(): void;
  /** A press that was not taken ended where it began. */
  click?(pointer: StagePointer): void;
  doubleClick?(pointer: StagePointer): void;
  /** Moving without a press; null when it leaves the picture. */
  hover?(pointer: StagePointer | null): void;
  /** @return  whether the tool has a use for this key */
  key?(event: KeyboardEvent): boolean;
}
