import type { Tuft } from "../api/contract";

/** A tuft as the contract has it, without what belongs to the page. */
export function bareTuft(tuft: Tuft): Tuft {
  const { id: _, ...bare } = tuft as Tuft & { readonly id?: number };
  return bare;
}
