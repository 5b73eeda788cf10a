import * as THREE from "three";
import { cutBelow } from "../../../client-examples/studio/src/paint/cutBelow";

/** Every edge once in each direction: closed, and wound one way. */
function isClosed(geometry: THREE.BufferGeometry): boolean {
  const { array } = geometry.getAttribute("position");
  const place = (i: number): string => [0, 1, 2].map((k) => (array[3 * i + k]! + 0).toFixed(5).replace("-0.00000", "0.00000")).join();
  const edges = new Map<string, number>();
  for (let i = 0; i < array.length / 3; i += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [place(i + k), place(i + ((k + 1) % 3))];
      if (a === b) continue; // at a pole
      const [key, way] = a < b ? [`${a} ${b}`, 1] : [`${b} ${a}`, -1];
      edges.set(key, (edges.get(key) ?? 0) + way);
    }
  }
  return [...edges.values()].every((sum) => sum === 0);
}

describe("cutBelow", () => {
  it("closes a ball at a column below the cut", () => {
    const cut = cutBelow(new THREE.SphereGeometry(1, 12, 9), -0.3, 0.2);
    cut.computeBoundingBox();
    expect(cut.boundingBox?.min.y).toBeCloseTo(-0.5, 6);
    expect(cut.boundingBox?.max.y).toBeCloseTo(1, 6);
    expect(isClosed(cut)).toBe(true);
  });

  it("leaves out the triangles it is told to", () => {
    const whole = cutBelow(new THREE.SphereGeometry(1, 12, 9), -2, 0.2);
    const half = cutBelow(new THREE.SphereGeometry(1, 12, 9), -2, 0.2, ([x]) => x > 0);
    expect(half.getAttribute("position").count).toBe(whole.getAttribute("position").count / 2);
  });
});
