import { Signal } from "../base/Signal";
import type { Doorkeeper } from "../key/Doorkeeper";
import type { ProblemDocument } from "./contract";
import { ServiceAway } from "./ServiceAway";
import { ServiceProblem } from "./ServiceProblem";

const kAskAgain_ms = 1500;

export interface Question {
  /** JSON, or a file as it is. */
  readonly body: unknown;
  readonly query?: Readonly<Record<string, string>>;
  readonly signal?: AbortSignal;
}

/** The service, over HTTP. While it is away it is asked every now and then whether it is back. */
export class Service {
  readonly isHere = new Signal(true);
  private waiting: ReturnType<typeof setTimeout> | null = null;

  /**
   * @param origin      where it listens; "" is where this page came from
   * @param doorkeeper  has a key where the service wants one; without it a refusal is a problem like others
   */
  constructor(private readonly origin = "", private readonly doorkeeper: Doorkeeper | null = null) {}

  async json<T>(path: string, question: Question): Promise<T> {
    return (await this.post(path, question, "application/json")).json() as Promise<T>;
  }

  async text(path: string, question: Question): Promise<string> {
    return (await this.post(path, question, "*/*")).text();
  }

  async bytes(path: string, question: Question, accept = "model/gltf-binary"): Promise<ArrayBuffer> {
    return (await this.post(path, question, accept)).arrayBuffer();
  }

  /** @throws ServiceProblem, ServiceAway, and DOMException AbortError if `signal` says so */
  private async post(path: string, question: Question, accept: string): Promise<Response> {
    for (;;) {
      const key = this.doorkeeper?.key ?? null;
      const answer = await this.send(path, question, accept, key);
      if (answer.ok) return answer;
      const problem = (await answer.json()) as ProblemDocument; // read in any case, or its connection stays taken
      if (answer.status !== 401 || !(await this.doorkeeper?.refused(key))) throw new ServiceProblem(problem);
    }
  }

  /** @return  what the service said, be it a problem */
  private async send(path: string, { body, query, signal }: Question, accept: string, key: string | null): Promise<Response> {
    const isFile = body instanceof Blob || body instanceof ArrayBuffer;
    let answer: Response;
    try {
      answer = await fetch(`${this.origin}${path}${query ? `?${new URLSearchParams(query)}` : ""}`, {
        method: "POST",
        headers: { Accept: accept, "Content-Type": isFile ? "application/octet-stream" : "application/json", ...(key === null ? {} : { Authorization: `Bearer ${key}` }) },
        body: isFile ? body : JSON.stringify(body),
        signal: signal ?? null,
      });
    } catch (error) {
      if (signal?.aborted) throw error;
      this.leave();
      throw new ServiceAway({ cause: error });
    }
    this.isHere.value = true;
    if (answer.ok) return answer;
    if (!answer.headers.get("Content-Type")?.startsWith("application/problem+json")) {
      this.leave(); // a proxy in between speaks for it
      throw new ServiceAway();
    }
    return answer;
  }

  private leave(): void {
    this.isHere.value = false;
    if (this.waiting !== null) return;
    this.waiting = setTimeout(async () => {
      this.waiting = null;
      const isBack = await fetch(`${this.origin}/v1/version`).then(({ ok, status }) => ok || status === 401, () => false); // bare: that it wants a key says enough
      if (isBack) this.isHere.value = true;
      else this.leave();
    }, kAskAgain_ms);
  }
}
