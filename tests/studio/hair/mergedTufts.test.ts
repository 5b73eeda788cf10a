import { markTufts } from "../../../client-examples/studio/src/hair/markTufts";
import { mergedTufts } from "../../../client-examples/studio/src/hair/mergedTufts";
import { tuftGeometry } from "../../../client-examples/studio/src/hair/tuftGeometry";

/** One triangle at x, whose corners hang on joints 0 and 1: the smallest with an index and more than one joint. */
function part(x: number, joints: number) {
  const geometry = tuftGeometry({
    positions: new Float32Array([x, 0, 0, x, 1, 0, x, 0, 1]),
    normals: new Float32Array([1, 0, 0, 1, 0, 0, 1, 0, 0]),
    joints: new Uint16Array([0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0]),
    weights: new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0]),
    indices: new Uint16Array([0, 1, 2]),
    rest: new Float32Array(3 * joints),
  });
  return { geometry, joints };
}

describe("mergedTufts", () => {
  const parts = [part(1, 2), part(2, 5), part(3, 2)];

  it("keeps every vertex, and triangles hang on their own vertices", () => {
    const merged = mergedTufts(parts);
    expect(Array.from({ length: 9 }, (_, i) => merged.getAttribute("position").getX(i))).toEqual([1, 1, 1, 2, 2, 2, 3, 3, 3]);
    expect([...merged.getIndex()!.array]).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8]);
    for (const [name, size] of [["normal", 3], ["smoothed", 3], ["weights", 4]] as const) expect(merged.getAttribute(name).array.length).toBe(9 * size);
  });

  it("counts joints through all tufts, as the poses do", () => {
    const joints = mergedTufts(parts).getAttribute("joints");
    expect([0, 1, 3, 4, 6, 7].map((i) => joints.getX(i))).toEqual([0, 1, 2, 3, 7, 8]);
  });

  it("leaves the parts as they were", () => {
    mergedTufts(parts);
    expect([...parts[1]!.geometry.getAttribute("joints").array].slice(0, 5)).toEqual([0, 0, 0, 0, 1]);
    expect([...parts[1]!.geometry.getIndex()!.array]).toEqual([0, 1, 2]);
  });

  it("is marked tuft by tuft, and can be marked anew", () => {
    const merged = mergedTufts(parts);
    markTufts(merged, parts, (tuft) => (tuft === 1 ? 0.5 : 0));
    expect([...merged.getAttribute("mark").array]).toEqual([0, 0, 0, 0.5, 0.5, 0.5, 0, 0, 0]);
    markTufts(merged, parts, (tuft) => (tuft === 2 ? 1 : 0));
    expect([...merged.getAttribute("mark").array]).toEqual([0, 0, 0, 0, 0, 0, 1, 1, 1]);
  });
});
