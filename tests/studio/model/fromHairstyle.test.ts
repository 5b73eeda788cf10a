import written from "../../../api/examples/hairstyles.json";
import type { Hairstyle } from "../../../client-examples/studio/src/api/contract";
import { fromHairstyle } from "../../../client-examples/studio/src/model/fromHairstyle";
import { toHairstyle } from "../../../client-examples/studio/src/model/toHairstyle";

const example = written as unknown as Hairstyle;

describe("fromHairstyle", () => {
  it("and back gives the head, the tufts, the motion and the color of the contract's example", () => {
    const back = toHairstyle(fromHairstyle(example, "example"));
    expect(back).toMatchObject({ head: example.head, tufts: example.tufts, motion: example.motion, mesh: { color: example.mesh!.color } });
    expect(Object.keys(back.tufts[0]!)).not.toContain("id");
  });

  it("names tufts that share a name apart, since fills and the list call them by it", () => {
    const points = example.tufts[0]!.points;
    expect(fromHairstyle({ tufts: [{ points }, { name: "x", points }, { name: "x", points }] }, "n").tufts.map(({ name }) => name)).toEqual(["tuft", "x", "x_2"]);
  });

  it("gives what is missing the values of a new document", () => {
    expect(fromHairstyle({ tufts: example.tufts }, "n").motion.timing).toEqual({ period: 0.45, fps: 24, hold: 2 });
  });
});
