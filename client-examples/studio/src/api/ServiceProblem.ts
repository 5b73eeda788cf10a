import type { FieldError, ProblemDocument } from "./contract";

/** An answer of the service that says what is wrong with a request. */
export class ServiceProblem extends Error {
  constructor(readonly document: ProblemDocument) {
    super(document.detail);
    this.name = "ServiceProblem";
  }

  /** The fields that are wrong, the first one first. */
  get fields(): readonly FieldError[] {
    return this.document.errors ?? [];
  }
}
