import { Plane, Ray, Vector3 } from "three";
import { Freehand } from "../../../client-examples/studio/src/draw/Freehand";

const shape = { diameter: 60, widest_at: 45 };
const view = new Vector3(0, 0, -1);
/** A head that is a ball of 0.1 m, seen from the front. */
const ball = (ray: Ray) => {
  const point = ray.intersectSphere({ center: new Vector3(), radius: 0.1 } as never, new Vector3());
  return point && { point, normal: point.clone().normalize() };
};
const rayTo = (x: number, y: number) => new Ray(new Vector3(x, y, 1), view.clone());
const drawn = (canvas: ConstructorParameters<typeof Freehand>[0], places: [number, number][]) => {
  const freehand = new Freehand(canvas, new Vector3(0, 0.0866, 0.05), 0.5);
  for (const [x, y] of places) freehand.follow(rayTo(x, y), 0.5);
  return freehand;
};
const down = Array.from({ length: 60 }, (_, i): [number, number] => [0, 0.085 - 0.003 * i]);

describe("Freehand", () => {
  it("follows the head at a distance near the pointer, then goes straight on beside it", () => {
    const { line } = drawn({ hit: ball, plane: null, view, scale: 1 }, down);
    for (const place of line.filter(({ y }) => y < 0.05 && y > 0)) expect(Math.abs(place.length() - 0.112)).toBeLessThan(0.001);
    const beside = line.map(({ y }, i) => Math.abs(y - (i === 0 ? 0.0866 : 0.085 - 0.003 * (i - 1))));
    expect(Math.max(...beside)).toBeLessThan(0.0085); // 12 mm at 45 degrees: where the head turns away from the eye
    for (let i = 1; i < line.length; i++) expect(line[i]!.distanceTo(line[i - 1]!)).toBeLessThan(0.05);
  });

  it("stays on a plane where one is given", () => {
    const plane = new Plane().setFromNormalAndCoplanarPoint(new Vector3(0, 0, 1), new Vector3(0, 0.0866, 0.05));
    for (const { z } of drawn({ hit: ball, plane, view, scale: 1 }, down).line) expect(z).toBeCloseTo(0.05, 9);
  });

  it("begins at the root and keeps few points", () => {
    const tuft = drawn({ hit: ball, plane: null, view, scale: 1 }, down).tuft(shape)!;
    expect(tuft.points[0]).toEqual([0, 0.0866, 0.05]);
    expect(tuft.points.length).toBeGreaterThan(3);
    expect(tuft.points.length).toBeLessThan(15);
    expect(tuft).toMatchObject(shape);
  });

  it("is nothing while the pointer only trembles", () => {
    expect(drawn({ hit: ball, plane: null, view, scale: 1 }, [[0, 0.0866], [0.0005, 0.0866]]).tuft(shape)).toBeNull();
  });

  it("looks the same on a head of ten times the size", () => {
    const big = (ray: Ray) => {
      const point = ray.intersectSphere({ center: new Vector3(), radius: 1 } as never, new Vector3());
      return point && { point, normal: point.clone().normalize() };
    };
    const freehand = new Freehand({ hit: big, plane: null, view, scale: 10 }, new Vector3(0, 0.866, 0.5), 0.5);
    for (const [x, y] of down) freehand.follow(new Ray(new Vector3(10 * x, 10 * y, 10), view.clone()), 0.5);
    const small = drawn({ hit: ball, plane: null, view, scale: 1 }, down).tuft(shape)!.points;
    freehand.tuft(shape)!.points.forEach((point, i) => point.forEach((x, axis) => expect(x / 10).toBeCloseTo(small[i]![axis]!, 4)));
  });
});
