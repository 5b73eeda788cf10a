import { thinnedMesh } from "../../../client-examples/studio/src/paint/thinnedMesh";

/** A sheet of so many squares a side, two triangles each. */
function sheet(squares: number): { positions: number[]; triangles: number[] } {
  const side = squares + 1;
  const positions = Array.from({ length: side * side }, (_, i) => [(i % side) / squares, Math.floor(i / side) / squares, 0]).flat();
  const triangles = Array.from({ length: squares * squares }, (_, i) => {
    const a = Math.floor(i / squares) * side + (i % squares);
    return [a, a + 1, a + side, a + 1, a + side + 1, a + side];
  }).flat();
  return { positions, triangles };
}

describe("thinnedMesh", () => {
  it("leaves a small mesh as it is", () => {
    const mesh = sheet(2);
    expect(thinnedMesh(mesh, 9)).toBe(mesh);
  });

  it("keeps within the limit, and its extent", () => {
    const { positions, triangles } = thinnedMesh(sheet(40), 500);
    expect(positions.length / 3).toBeLessThanOrEqual(500);
    expect(triangles.length / 3).toBeLessThanOrEqual(500);
    expect(triangles.length).toBeGreaterThan(0);
    expect(Math.max(...triangles)).toBeLessThan(positions.length / 3);
    expect(Math.max(...positions)).toBeGreaterThan(0.9);
  });
});
