import { weldedMesh } from "../../../client-examples/studio/src/paint/weldedMesh";

describe("weldedMesh", () => {
  it("shares the vertices of two triangles that touch", () => {
    const { positions, triangles } = weldedMesh([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0]);
    expect(positions).toEqual([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0]);
    expect(triangles).toEqual([0, 1, 2, 2, 1, 3]);
  });

  it("rounds to a micrometre, and leaves out what has no area after it", () => {
    const { positions, triangles } = weldedMesh([0.12345678, 0, 0, 0.1234569, 0, 0, 0, 1, 0]);
    expect(positions).toEqual([0.123457, 0, 0, 0, 1, 0]);
    expect(triangles).toEqual([]);
  });
});
