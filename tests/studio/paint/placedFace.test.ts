import { kHeadPlace } from "../../../client-examples/studio/src/paint/HeadPlace";
import { placedFace } from "../../../client-examples/studio/src/paint/placedFace";

// The smallest place that tells scale from position and the axes from each other.
const kPlace = { scale: [2, 3, 4], position: [10, 20, 30] } as const;

describe("placedFace", () => {
  it("lies in the middle of the studio's head, under the crown", () => {
    const { box: [left, bottom, right, top], front } = placedFace(kHeadPlace);
    expect(left + right).toBeCloseTo(0, 9);
    expect(right).toBeCloseTo(0.0864, 4);
    expect(top).toBeLessThan(0.1);
    expect(bottom).toBeGreaterThan(-0.2);
    expect(front).toBeCloseTo(0.046, 3);
  });

  it("follows the head's place", () => {
    const { box, front } = placedFace(kPlace);
    const sizes = [box[0] - 10, box[1] - 20, box[2] - 10, box[3] - 20];
    const own = placedFace({ scale: [1, 1, 1], position: [0, 0, 0] });
    expect(sizes[0]).toBeCloseTo(2 * own.box[0], 9);
    expect(sizes[1]).toBeCloseTo(3 * own.box[1], 9);
    expect(sizes[2]).toBeCloseTo(2 * own.box[2], 9);
    expect(sizes[3]).toBeCloseTo(3 * own.box[3], 9);
    expect(front - 30).toBeCloseTo(4 * own.front, 9);
  });
});
