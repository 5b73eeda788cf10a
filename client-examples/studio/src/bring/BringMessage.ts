import type { ServiceProblem } from "../api/ServiceProblem";

/** What is to be said about a file that was brought. */
export type BringMessage =
  | { readonly kind: "opening" | "unread" | "cut" | "empty" | "unshown" | "away" | "notKept"; readonly name: string }
  | { readonly kind: "refused"; readonly name: string; readonly problem: ServiceProblem };
