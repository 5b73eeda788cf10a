import { addTufts } from "../../../client-examples/studio/src/model/addTufts";
import { newDocument } from "../../../client-examples/studio/src/model/newDocument";
import type { StudioDocument } from "../../../client-examples/studio/src/model/StudioDocument";

/** Three tufts, ids 1 to 3: a, b and c. */
export function sampleDocument(): StudioDocument {
  return addTufts(newDocument(), ["a", "b", "c"].map((name, i) => ({ name, points: [[0.01 * i, 0.1, 0], [0.02, 0.05, 0.1], [0.03, 0, 0.12]] })));
}
