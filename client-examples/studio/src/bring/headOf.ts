import type { CharacterChainsAnswer, Head } from "../api/contract";
import { rangeOf } from "../api/rangeOf";
import type { HeadBall } from "../model/HeadBall";

const kDepth = 0.12; // of the radius, as with the bundled head

function within(value: number, { minimum, maximum }: { readonly minimum: number; readonly maximum: number }): number {
  return Number(Math.min(maximum, Math.max(minimum, value)).toPrecision(4));
}

/** A head as the document has it: hair as thick and as deep in proportion as on the bundled head. @param facing  where the face looks */
export function headOf({ center, radius }: HeadBall, facing: CharacterChainsAnswer["facing"]): Head {
  const round = (value: number) => Number(value.toFixed(6)) + 0;
  return {
    center: [round(center[0]), round(center[1]), round(center[2])],
    front: [0, 0, facing === "-Z" ? -1 : 1],
    root_depth: within(kDepth * radius, rangeOf("Head", "root_depth")),
    diameter_at_100: within(radius, rangeOf("Head", "diameter_at_100")),
    scalp: null,
  };
}
