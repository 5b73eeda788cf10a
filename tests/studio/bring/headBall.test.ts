import { headBall } from "../../../client-examples/studio/src/bring/headBall";

/** Loose triangles of a box: the sides of its four walls and its lid. */
function box([x, y, z]: readonly [number, number, number], [width, height, depth]: readonly [number, number, number]): number[] {
  const [l, r, b, t, n, f] = [x - width / 2, x + width / 2, y - height / 2, y + height / 2, z - depth / 2, z + depth / 2];
  const quad = (a: number[], c: number[], d: number[], e: number[]) => [...a, ...c, ...d, ...a, ...d, ...e];
  return [
    ...quad([l, b, f], [r, b, f], [r, t, f], [l, t, f]), ...quad([l, b, n], [r, b, n], [r, t, n], [l, t, n]),
    ...quad([l, b, n], [l, b, f], [l, t, f], [l, t, n]), ...quad([r, b, n], [r, b, f], [r, t, f], [r, t, n]),
    ...quad([l, t, n], [r, t, n], [r, t, f], [l, t, f]),
  ];
}

// A person of boxes: head, neck, shoulders; metres.
const kPerson = [...box([0, 1.6, 0], [0.16, 0.24, 0.2]), ...box([0, 1.44, 0], [0.1, 0.08, 0.1]), ...box([0, 0.7, 0], [0.5, 1.4, 0.3])];

describe("headBall", () => {
  it("finds the skull above the neck, under the crown", () => {
    const { center, radius } = headBall(kPerson, null);
    expect(radius).toBeCloseTo(0.1, 2);
    expect(center[0]).toBeCloseTo(0, 6);
    expect(center[1]).toBeCloseTo(1.72 - radius, 6);
    expect(center[2]).toBeCloseTo(0, 6);
  });

  it.each([100, 10, 0.01])("finds it just so in a file %f times as large", (factor) => {
    const { center, radius } = headBall(kPerson.map((part) => part * factor), null);
    const small = headBall(kPerson, null);
    expect(radius / factor).toBeCloseTo(small.radius, 6);
    expect(center[1] / factor).toBeCloseTo(small.center[1], 6);
  });

  it("takes all of what has no neck for the head", () => {
    const { center, radius } = headBall(box([0, 0, 0], [1, 1, 1]), null);
    expect(radius).toBeCloseTo(0.42, 6);
    expect(center).toEqual([0, 0.5 - radius, 0]);
  });

  it("keeps a center that is known, and takes what is above it for its size", () => {
    const { center, radius } = headBall(kPerson, [0, 1.62, 0]);
    expect(center).toEqual([0, 1.62, 0]);
    expect(radius).toBeCloseTo(Math.sqrt(0.08 ** 2 + 0.1 ** 2 + 0.1 ** 2), 6);
  });

  it("gives a flat thing a radius that is more than nothing", () => {
    expect(headBall([0, 0, 0, 1, 0, 0, 0, 0, 0], null).radius).toBeGreaterThan(0);
  });
});
