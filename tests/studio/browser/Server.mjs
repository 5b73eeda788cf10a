import { execFile, spawn } from "node:child_process";
import { once } from "node:events";
import { createInterface } from "node:readline";
import { promisify } from "node:util";

/** A server on a port of its own, which it keeps when it is stopped and started again. */
export class Server {
  #binary;
  #process = null;
  #port = 0;

  /** @param binary  path of tuftwave-server */
  constructor(binary) {
    this.#binary = binary;
  }

  get origin() {
    return `http://127.0.0.1:${this.#port}`;
  }

  /** A fresh key, and its line for a key file. */
  async newKey(name) {
    const { stdout, stderr } = await promisify(execFile)(this.#binary, ["new-key", name]);
    return { key: stderr.trim().split("\n").at(-1), line: stdout };
  }

  /** Returns when it answers. @param more  options besides @throws Error if it ends before */
  async start(...more) {
    const words = ["--host", "127.0.0.1", "--port", String(this.#port), "--admin-port", "0", "--drain", "0", "--log-level", "error", ...more];
    this.#process = spawn(this.#binary, words, { stdio: ["ignore", "pipe", "inherit"] });
    const failed = once(this.#process, "exit").then(([code]) => Promise.reject(new Error(`${this.#binary} ended with ${code}`)));
    failed.catch(() => {}); // later it may end
    const lines = createInterface({ input: this.#process.stdout });
    const [line] = await Promise.race([once(lines, "line"), failed]);
    const port = /listening on http:\/\/[^ ,]+:(\d+)/.exec(line)?.[1];
    if (!port) throw new Error(`no address in "${line}"`);
    this.#port = Number(port);
  }

  /** Ends it at once, as when the power fails. */
  async stop() {
    const process = this.#process;
    this.#process = null;
    if (!process || process.exitCode !== null) return;
    const ended = once(process, "exit");
    process.kill("SIGKILL");
    await ended;
  }
}
