/** A part of the page. */
export interface Part {
  readonly element: HTMLElement;
  /** It is taken away for good: nothing is followed any more. */
  dispose(): void;
}
