/** What stands beside the picture in one mode. */
export interface Panel {
  readonly element: HTMLElement;
  /** It is taken away for good: nothing is followed any more. */
  dispose(): void;
}
