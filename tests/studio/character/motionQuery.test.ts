import type { CharacterChain } from "../../../client-examples/studio/src/api/contract";
import { motionQuery } from "../../../client-examples/studio/src/character/motionQuery";
import { newDocument } from "../../../client-examples/studio/src/model/newDocument";

const chain = (index: number, kind: CharacterChain["kind"]) => ({ index, kind }) as CharacterChain;
const kChains = [chain(0, "hair"), chain(1, "hair"), chain(2, "skirt"), chain(3, "ribbon")];

describe("motionQuery", () => {
  it("says what the document's motion says", () => {
    expect(motionQuery(newDocument().motion, kChains, [0, 1], true)).toEqual({
      kinds: "hair", amplitude: "0.3", spatial_period: "1", lightness: "1.2", tip_exponent: "1.5", period: "0.45", fps: "24", hold: "2",
      wind: "1,0,0", one_sided: "true", gust_wavelength: "0.8", spread: "0.08", seed: "7",
    });
  });

  it("leaves out what is null, and one side where no head is known", () => {
    const query = motionQuery({ one_sided: true, lift: null, up: null, droop: null, phase: { gust_wavelength: null } }, kChains, [0, 1], false);
    expect(query).toEqual({ kinds: "hair" });
  });

  it("keeps a zero, and a frame rate that is a fraction", () => {
    expect(motionQuery({ lift: 0, timing: { fps: "24000/1001" }, phase: { step: "picture" } }, kChains, [2], true)).toEqual({ kinds: "skirt", lift: "0", fps: "24000/1001", phase_step: "picture" });
  });

  it.each([[[0, 1, 3], { kinds: "hair,ribbon" }], [[0, 1, 2, 3], { kinds: "hair,skirt,ribbon" }], [[0], { chains: "0" }], [[1, 2], { chains: "1,2" }]])("names kinds if %j are whole kinds", (chosen, expected) => {
    expect(motionQuery({}, kChains, chosen, true)).toEqual(expected);
  });
});
