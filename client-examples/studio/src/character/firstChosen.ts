import type { CharacterChainsAnswer } from "../api/contract";

/** The chains that move before anybody picks: the hair, or all where nothing looks like hair. @return  their indices */
export function firstChosen({ chains }: CharacterChainsAnswer): readonly number[] {
  const hair = chains.filter(({ kind }) => kind === "hair");
  return (hair.length > 0 ? hair : chains).map(({ index }) => index);
}
