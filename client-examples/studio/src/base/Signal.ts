/** A value that others follow. */
export class Signal<T> {
  private readonly listeners = new Set<(value: T) => void>();

  constructor(private current: T) {}

  get value(): T {
    return this.current;
  }

  /** Listeners hear of it only if it is another value. */
  set value(next: T) {
    if (Object.is(next, this.current)) return;
    this.current = next;
    for (const listener of [...this.listeners]) listener(next);
  }

  /** Calls `listener` now and at every change. @return  ends that */
  follow(listener: (value: T) => void): () => void {
    listener(this.current);
    return this.changed(listener);
  }

  /** Calls `listener` at every change. @return  ends that */
  changed(listener: (value: T) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
