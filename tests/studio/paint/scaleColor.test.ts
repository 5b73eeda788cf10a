import { scaleColor } from "../../../client-examples/studio/src/paint/scaleColor";

describe("scaleColor", () => {
  it("scales each part, and goes no further than white", () => {
    expect(scaleColor("#804020", [1, 0.5, 2])).toBe("#802040");
    expect(scaleColor("#ff8000", [2, 2, 2])).toBe("#ffff00");
  });
});
