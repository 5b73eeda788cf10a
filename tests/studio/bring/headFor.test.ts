import { headFor } from "../../../client-examples/studio/src/bring/headFor";
import type { Head } from "../../../client-examples/studio/src/api/contract";

const place = (name: string, center: [number, number, number], diameter_at_100: number) => ({ name, head: { center, diameter_at_100 } as Head });
const kBundled = place("bundled", [0, 0, 0], 0.1);
const kTall = place("tall", [0, 1.5, 0], 0.12);
const kHuge = place("huge", [0, 0, 0], 10);

describe("headFor", () => {
  it.each([kBundled, kTall, kHuge])("finds the very head: $name", (one) => {
    expect(headFor(one.head, [kBundled, kTall, kHuge])).toBe(one);
  });

  it("takes a head that is left out for the bundled one", () => {
    expect(headFor({}, [kTall, kBundled])).toBe(kBundled);
  });

  it("takes the nearest for hair of other measures", () => {
    expect(headFor({ center: [0, 1.45, 0.02], diameter_at_100: 0.1 }, [kBundled, kTall, kHuge])).toBe(kTall);
    expect(headFor({ center: [0, 0.01, 0], diameter_at_100: 0.08 }, [kBundled, kTall, kHuge])).toBe(kBundled);
  });
});
