import type { Head } from "../api/contract";
import { rangeOf } from "../api/rangeOf";

/** How large a head is beside the bundled one, whose thickest tuft is 0.1 m: what is drawn around it is as much larger. */
export function headScale({ diameter_at_100 }: Head): number {
  const usual = rangeOf("Head", "diameter_at_100").default!;
  return (diameter_at_100 ?? usual) / usual;
}
