const kDatabase = "tuftwave";
const kStore = "files";

function answerOf<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("the browser's store failed"));
    if (request instanceof IDBOpenDBRequest) request.onblocked = () => reject(new Error("the browser's store is blocked"));
  });
}

/** Files that this browser keeps, by name. Where it keeps nothing, or no more, all is as if nothing had been put there. */
export class FileStore {
  private database: Promise<IDBDatabase> | null = null;

  /** @return  null if there is none */
  async get<T>(name: string): Promise<T | null> {
    try {
      return ((await answerOf((await this.open("readonly")).get(name))) as T | undefined) ?? null;
    } catch {
      return null;
    }
  }

  /** @param value  what can be cloned: plain objects, buffers; null takes it away. @return  whether it is kept */
  async put(name: string, value: unknown): Promise<boolean> {
    try {
      const store = await this.open("readwrite");
      await (value === null ? answerOf(store.delete(name)) : answerOf(store.put(value, name)));
      return true;
    } catch {
      return false;
    }
  }

  private async open(mode: IDBTransactionMode): Promise<IDBObjectStore> {
    this.database ??= this.connect();
    return (await this.database).transaction(kStore, mode).objectStore(kStore);
  }

  private async connect(): Promise<IDBDatabase> {
    const request = indexedDB.open(kDatabase, 1);
    request.onupgradeneeded = () => request.result.createObjectStore(kStore);
    return answerOf(request);
  }
}
