import { rangeOf } from "../../../client-examples/studio/src/api/rangeOf";

describe("rangeOf", () => {
  it("reads a property", () => {
    expect(rangeOf("Tuft", "diameter")).toMatchObject({ minimum: 1, maximum: 100, default: 40, integer: false });
    expect(rangeOf("Tuft", "joints")).toMatchObject({ minimum: 1, maximum: 64, default: 6, integer: true });
  });

  it("follows references, and takes one of several schemas that has a range", () => {
    expect(rangeOf("Timing", "period")).toMatchObject({ minimum: 0.01, maximum: 60, default: 0.45 });
    expect(rangeOf("Density")).toMatchObject({ minimum: 1, maximum: 100 });
  });

  it("throws where the contract gives no range", () => {
    expect(() => rangeOf("Tuft", "name")).toThrow("Tuft name");
    expect(() => rangeOf("Tuft", "thickness")).toThrow("thickness");
  });
});
