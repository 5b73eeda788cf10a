import { Signal } from "../base/Signal";
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

  /** @param origin  where it listens; "" is where this page came from */
  constructor(private readonly origin = "") {}

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
  private async post(path: string, { body, query, signal }: Question, accept: string): Promise<Response> {
    const isFile = body instanceof Blob || body instanceof ArrayBuffer;
    let answer: Response;
    try {
      answer = await fetch(`${this.origin}${path}${query ? `?${new URLSearchParams(query)}` : ""}`, {
        method: "POST",
        headers: { Accept: accept, "Content-Type": isFile ? "application/octet-stream" : "application/json" },
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
    throw new ServiceProblem((await answer.json()) as ProblemDocument);
  }

  private leave(): void {
    this.isHere.value = false;
    if (this.waiting !== null) return;
    this.waiting = setTimeout(async () => {
      this.waiting = null;
      const isBack = await fetch(`${this.origin}/v1/version`).then(({ ok }) => ok, () => false);
      if (isBack) this.isHere.value = true;
      else this.leave();
    }, kAskAgain_ms);
  }
}
