import type { Vec3 } from "../../../client-examples/studio/src/api/contract";
import { strokeWidth } from "../../../client-examples/studio/src/draw/strokeWidth";

const line: Vec3[] = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0], [4, 0, 0]];
const chosen = { diameter: 40, widest_at: 45 };

describe("strokeWidth", () => {
  it("is what was chosen for a mouse, whose pressure is even", () => {
    expect(strokeWidth(line, [0.5, 0.5, 0.5, 0.5, 0.5], chosen)).toEqual(chosen);
  });

  it("grows with the pressure of a pen, within the contract's range", () => {
    const of = (pressure: number) => strokeWidth(line, line.map(() => pressure), chosen).diameter;
    expect(of(0.1)).toBeLessThan(of(0.4));
    expect(of(0.4)).toBeLessThan(of(0.9));
    expect(of(1)).toBe(80);
    expect(strokeWidth(line, line.map(() => 1), { diameter: 90, widest_at: 45 }).diameter).toBe(100);
    expect(strokeWidth(line, line.map(() => 0.001), { diameter: 1, widest_at: 45 }).diameter).toBe(1);
  });

  it("is widest where the pen was pressed most", () => {
    expect(strokeWidth(line, [0.1, 0.2, 0.3, 0.9, 0.2], chosen).widest_at).toBe(75);
    expect(strokeWidth(line, [0.9, 0.2, 0.2, 0.2, 0.2], chosen).widest_at).toBe(10);
  });
});
