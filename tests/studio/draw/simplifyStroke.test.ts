import type { Vec3 } from "../../../client-examples/studio/src/api/contract";
import { simplifyStroke } from "../../../client-examples/studio/src/draw/simplifyStroke";

describe("simplifyStroke", () => {
  it("keeps the ends of a straight line, however many points it has", () => {
    expect(simplifyStroke(Array.from({ length: 500 }, (_, i): Vec3 => [i, 2 * i, 0]), 0.01)).toEqual([0, 499]);
  });

  it("keeps a corner", () => {
    expect(simplifyStroke([[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 1, 0], [2, 2, 0]], 0.1)).toEqual([0, 2, 4]);
  });

  it("leaves out no point further from the line than the tolerance", () => {
    const arc = Array.from({ length: 200 }, (_, i): Vec3 => [Math.cos(i / 60), Math.sin(i / 60), 0]);
    const kept = simplifyStroke(arc, 0.01);
    expect(kept.length).toBeGreaterThan(4);
    expect(kept.length).toBeLessThan(20);
    kept.slice(1).forEach((to, k) => {
      const from = kept[k]!;
      const [a, b] = [arc[from]!, arc[to]!];
      const length = Math.sqrt((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2);
      for (let i = from; i <= to; i++) expect(Math.abs((arc[i]![0] - a[0]) * (b[1] - a[1]) - (arc[i]![1] - a[1]) * (b[0] - a[0])) / length).toBeLessThanOrEqual(0.01);
    });
  });

  it("bears two points, one place many times, and a point that comes back", () => {
    expect(simplifyStroke([[0, 0, 0], [1, 0, 0]], 0.1)).toEqual([0, 1]);
    expect(simplifyStroke([[0, 0, 0], [0, 0, 0], [0, 0, 0]], 0.1)).toEqual([0, 2]);
    expect(simplifyStroke([[0, 0, 0], [1, 0, 0], [0, 0, 0]], 0.1)).toEqual([0, 1, 2]);
  });
});
