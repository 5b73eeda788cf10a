import { addTufts } from "../../../client-examples/studio/src/model/addTufts";
import { changeTufts } from "../../../client-examples/studio/src/model/changeTufts";
import { duplicateTufts } from "../../../client-examples/studio/src/model/duplicateTufts";
import { insertPoint } from "../../../client-examples/studio/src/model/insertPoint";
import { movePoint } from "../../../client-examples/studio/src/model/movePoint";
import { moveTuft } from "../../../client-examples/studio/src/model/moveTuft";
import { removePoint } from "../../../client-examples/studio/src/model/removePoint";
import { removeTufts } from "../../../client-examples/studio/src/model/removeTufts";
import { renameTuft } from "../../../client-examples/studio/src/model/renameTuft";
import type { StudioDocument } from "../../../client-examples/studio/src/model/StudioDocument";
import { sampleDocument } from "./sampleDocument";

const names = ({ tufts }: StudioDocument) => tufts.map(({ name }) => name);
const ids = ({ tufts }: StudioDocument) => tufts.map(({ id }) => id);

describe("edits of the list of tufts", () => {
  it.each([
    ["addTufts", (d: StudioDocument) => addTufts(d, [{ points: [[0, 0.1, 0], [0, 0, 0.1]] }])],
    ["changeTufts", (d: StudioDocument) => changeTufts(d, [2], (tuft) => ({ ...tuft, diameter: 7 }))],
    ["removeTufts", (d: StudioDocument) => removeTufts(d, [2])],
    ["moveTuft", (d: StudioDocument) => moveTuft(d, 1, 2)],
    ["renameTuft", (d: StudioDocument) => renameTuft(d, 1, "x")],
    ["duplicateTufts", (d: StudioDocument) => duplicateTufts(d, [1]).document],
  ])("%s leaves the old document as it was", (_, edit) => {
    const document = sampleDocument();
    const before = structuredClone(document);
    expect(edit(document)).not.toEqual(before);
    expect(document).toEqual(before);
  });

  it("adds with new ids and names of their own", () => {
    const more = addTufts(sampleDocument(), [{ name: "a", points: [[0, 0.1, 0], [0, 0, 0.1]] }, { name: "a", points: [[0, 0.1, 0], [0, 0, 0.1]] }]);
    expect(names(more)).toEqual(["a", "b", "c", "a_2", "a_3"]);
    expect(ids(more)).toEqual([1, 2, 3, 4, 5]);
  });

  it("never gives an id twice, also after the last tuft was removed and another added", () => {
    const removed = removeTufts(sampleDocument(), [1]);
    expect(new Set(ids(addTufts(removed, removed.tufts))).size).toBe(4);
  });

  it("changes only the tufts that are meant, and never an id", () => {
    const changed = changeTufts(sampleDocument(), [1, 3], (tuft) => ({ ...tuft, id: 99, diameter: 7 }));
    expect(changed.tufts.map(({ diameter }) => diameter)).toEqual([7, undefined, 7]);
    expect(ids(changed)).toEqual([1, 2, 3]);
  });

  it("moves a tuft within the list, and not beyond its ends", () => {
    expect(names(moveTuft(sampleDocument(), 1, 1))).toEqual(["b", "a", "c"]);
    expect(names(moveTuft(sampleDocument(), 3, -5))).toEqual(["c", "a", "b"]);
    expect(names(moveTuft(sampleDocument(), 1, 9))).toEqual(["b", "c", "a"]);
  });

  it("numbers a name that another tuft has, and leaves a tuft its own", () => {
    expect(names(renameTuft(sampleDocument(), 1, "b"))).toEqual(["b_2", "b", "c"]);
    expect(names(renameTuft(sampleDocument(), 1, "a"))).toEqual(["a", "b", "c"]);
  });

  it("duplicates at the end and says which are new", () => {
    const { document, added } = duplicateTufts(sampleDocument(), [2, 1]);
    expect(names(document)).toEqual(["a", "b", "c", "b_2", "a_2"]);
    expect(added).toEqual([4, 5]);
  });
});

describe("edits of the points of a tuft", () => {
  const tuft = sampleDocument().tufts[0]!;

  it("inserts, moves and removes a point", () => {
    expect(insertPoint(tuft, 1, [9, 9, 9]).points.map(([x]) => x)).toEqual([0, 9, 0.02, 0.03]);
    expect(movePoint(tuft, 2, [9, 9, 9]).points.map(([x]) => x)).toEqual([0, 0.02, 9]);
    expect(removePoint(tuft, 1).points.map(([x]) => x)).toEqual([0, 0.03]);
  });

  it("keeps the root, and two points", () => {
    expect(insertPoint(tuft, 0, [9, 9, 9]).points[0]).toEqual(tuft.points[0]);
    expect(removePoint(tuft, 0)).toBe(tuft);
    const line = removePoint(tuft, 1);
    expect(removePoint(line, 1)).toBe(line);
  });
});
