import { headOf } from "../../../client-examples/studio/src/bring/headOf";

describe("headOf", () => {
  it("gives a ball of the bundled head's size the bundled head's measures", () => {
    expect(headOf({ center: [0, 0, 0], radius: 0.1 }, "+Z")).toEqual({ center: [0, 0, 0], front: [0, 0, 1], root_depth: 0.012, diameter_at_100: 0.1, scalp: null });
  });

  it.each([[10, 1.2, 10], [0.001, 0.00012, 0.001], [1e6, 10, 1000]])("keeps the proportions at a radius of %f, within the contract's ranges", (radius, root_depth, diameter_at_100) => {
    expect(headOf({ center: [0, 0, 0], radius }, "+Z")).toMatchObject({ root_depth, diameter_at_100 });
  });

  it("looks where the file looks", () => {
    expect(headOf({ center: [0, 1, 0], radius: 0.1 }, "-Z")).toMatchObject({ center: [0, 1, 0], front: [0, 0, -1] });
  });
});
