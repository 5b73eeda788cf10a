import { smoothedNormals } from "../../../client-examples/studio/src/paint/smoothedNormals";

describe("smoothedNormals", () => {
  it("gives vertices at one place one normal of length 1, and leaves others alone", () => {
    const smoothed = smoothedNormals([1, 2, 3, 1, 2, 3, 4, 5, 6], [1, 0, 0, 0, 1, 0, 0, 0, 1]);
    const half = Math.SQRT1_2;
    expect([...smoothed].map((x) => +x.toFixed(6))).toEqual([half, half, 0, half, half, 0, 0, 0, 1].map((x) => +x.toFixed(6)));
  });

  it("takes places within a micrometre as one, and a millimetre apart as two", () => {
    const normals = [1, 0, 0, 0, 0, 1];
    expect(smoothedNormals([0.1, 0, 0, 0.1000001, 0, 0], normals)[2]).toBeCloseTo(Math.SQRT1_2, 5);
    expect([...smoothedNormals([0.1, 0, 0, 0.101, 0, 0], normals)]).toEqual(normals);
  });

  it("keeps a vertex's own normal where normals cancel out", () => {
    expect([...smoothedNormals([0, 0, 0, 0, 0, 0], [0, 1, 0, 0, -1, 0])]).toEqual([0, 1, 0, 0, -1, 0]);
  });

  it("holds nothing for nothing", () => {
    expect(smoothedNormals([], [])).toHaveLength(0);
  });

  it("finds its way when many places share a hash", () => {
    const count = 5000;
    const positions = Float32Array.from({ length: 3 * count }, (_, i) => (i % 3 === 0 ? Math.floor(i / 6) * 1e-6 : 0)); // pairs
    const normals = Float32Array.from({ length: 3 * count }, (_, i) => (i % 6 === 0 || i % 6 === 4 ? 1 : 0)); // x, then y
    const smoothed = smoothedNormals(positions, normals);
    for (let i = 0; i < 3 * count; i++) expect(smoothed[i]).toBeCloseTo(i % 3 < 2 ? Math.SQRT1_2 : 0, 5);
  });
});
