import { Signal } from "../base/Signal";

const kSteps = 200;

/**
 * A value with its past and its future. Values are never changed in place, so that a step costs no copy.
 * Changes with the same `merge` one after the other are one step: a slider that is dragged, a point that is moved.
 */
export class History<T> {
  private past: T[] = [];
  private future: T[] = [];
  private merging: string | null = null;
  readonly current: Signal<T>;

  constructor(value: T) {
    this.current = new Signal(value);
  }

  get value(): T {
    return this.current.value;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** Another value altogether, without past or future. */
  begin(value: T): void {
    this.past = [];
    this.future = [];
    this.merging = null;
    this.current.value = value;
  }

  /** @param merge  what is being done; null is a step of its own */
  change(value: T, merge: string | null = null): void {
    if (Object.is(value, this.value)) return;
    if (merge === null || merge !== this.merging) this.past = [...this.past, this.value].slice(-kSteps);
    this.merging = merge;
    this.future = [];
    this.current.value = value;
  }

  /** Ends a run of merged changes: the next is another step. */
  settle(): void {
    this.merging = null;
  }

  undo(): void {
    const value = this.past.pop();
    if (value === undefined) return;
    this.future.push(this.value);
    this.merging = null;
    this.current.value = value;
  }

  redo(): void {
    const value = this.future.pop();
    if (value === undefined) return;
    this.past.push(this.value);
    this.merging = null;
    this.current.value = value;
  }
}
