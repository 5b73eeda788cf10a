import { addTufts } from "../../../client-examples/studio/src/model/addTufts";
import { moveToHead } from "../../../client-examples/studio/src/model/moveToHead";
import { newDocument } from "../../../client-examples/studio/src/model/newDocument";

const kDocument = addTufts(newDocument(), [{ name: "fringe", points: [[0.02, 0.1, 0], [0.03, 0.05, 0.1]] }]);

describe("moveToHead", () => {
  it("keeps hair where it is on the same head", () => {
    expect(moveToHead(kDocument, kDocument.head)).toEqual(kDocument);
  });

  it("carries it to another center, as large as the head", () => {
    const head = { center: [0, 1.5, 0] as [number, number, number], diameter_at_100: 0.2 };
    const moved = moveToHead(kDocument, head);
    expect(moved.head).toBe(head);
    expect(moved.tufts[0]!.points).toEqual([[0.04, 1.7, 0], [0.06, 1.6, 0.2]]);
    expect(moved.motion.phase?.gust_wavelength).toBe(1.6);
  });

  it("turns it to a face that looks the other way", () => {
    const moved = moveToHead(kDocument, { ...kDocument.head, front: [0, 0, -1] });
    expect(moved.tufts[0]!.points).toEqual([[-0.02, 0.1, 0], [-0.03, 0.05, -0.1]]);
  });

  it("comes back to where it was", () => {
    const there = moveToHead(kDocument, { center: [1, 2, 3], diameter_at_100: 0.13, front: [0, 0, -1] });
    const back = moveToHead(there, kDocument.head).tufts[0]!.points.flat();
    back.forEach((part, i) => expect(part).toBeCloseTo(kDocument.tufts[0]!.points.flat()[i]!, 5));
  });
});
