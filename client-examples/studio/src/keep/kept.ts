/** A text that the browser keeps under a name, where it keeps anything: it may be told not to, or be full. */
export function kept(name: string): { read(): string | null; write(text: string): boolean } {
  return {
    read() {
      try {
        return localStorage.getItem(name);
      } catch {
        return null;
      }
    },
    /** @return  whether it is kept now */
    write(text) {
      try {
        localStorage.setItem(name, text);
        return true;
      } catch {
        return false;
      }
    },
  };
}
