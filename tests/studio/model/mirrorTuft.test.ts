import { mirrorTuft } from "../../../client-examples/studio/src/model/mirrorTuft";

const tuft = { name: "side_L", points: [[0.02, 0.1, 0.01], [0.05, 0.02, 0.1]], twist_deg: 30, roll_deg: -10 } satisfies Parameters<typeof mirrorTuft>[0];

describe("mirrorTuft", () => {
  it("turns left into right across the face", () => {
    expect(mirrorTuft(tuft, {}).points).toEqual([[-0.02, 0.1, 0.01], [-0.05, 0.02, 0.1]]);
  });

  it("mirrors through the head's center, wherever its face looks", () => {
    // A head at x = 1 that looks along +X: its sides are along Z.
    const [root] = mirrorTuft({ ...tuft, points: [[1.1, 0.1, 0.3], [1.2, 0, 0.3]] }, { center: [1, 0, 0.1], front: [1, 0, 0] }).points;
    expect(root!.map((x) => +x.toFixed(9))).toEqual([1.1, 0.1, -0.1]);
  });

  it("turns twist and roll the other way", () => {
    expect(mirrorTuft(tuft, {})).toMatchObject({ twist_deg: -30, roll_deg: 10 });
  });

  it("is undone by itself", () => {
    expect(mirrorTuft(mirrorTuft(tuft, {}), {})).toEqual(tuft);
  });

  it.each([["side_L", "side_R"], ["side_R2", "side_L2"], ["l.front", "l.front_m"], ["hair.l", "hair.r"], ["ahoge", "ahoge_m"]])("calls %s %s", (name, mirrored) => {
    expect(mirrorTuft({ ...tuft, name }, {}).name).toBe(mirrored);
  });
});
