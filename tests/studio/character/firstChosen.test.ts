import type { CharacterChain, CharacterChainsAnswer } from "../../../client-examples/studio/src/api/contract";
import { firstChosen } from "../../../client-examples/studio/src/character/firstChosen";

const found = (...kinds: CharacterChain["kind"][]) => ({ chains: kinds.map((kind, index) => ({ kind, index })) }) as unknown as CharacterChainsAnswer;

describe("firstChosen", () => {
  it("picks the hair", () => {
    expect(firstChosen(found("skirt", "hair", "ribbon", "hair"))).toEqual([1, 3]);
  });

  it("picks all where nothing looks like hair", () => {
    expect(firstChosen(found("unknown", "skirt"))).toEqual([0, 1]);
  });
});
