import type { CharacterChain, Motion } from "../api/contract";

function kindsOf(chains: readonly CharacterChain[], chosen: ReadonlySet<number>): string[] | null {
  const kinds = new Set(chains.filter(({ index }) => chosen.has(index)).map(({ kind }) => kind));
  return chains.every(({ index, kind }) => chosen.has(index) === kinds.has(kind)) ? [...kinds] : null;
}

/**
 * A motion as the query of /v1/characters/motion; what it leaves out is left to the service.
 * @param chosen  indices of the chains that move; not empty
 * @param knowsHead  whether the file says where the head is: without it hair cannot be kept from swinging into it
 */
export function motionQuery(motion: Motion, chains: readonly CharacterChain[], chosen: readonly number[], knowsHead: boolean): Record<string, string> {
  const { wave = {}, timing = {}, phase = {} } = motion;
  // Kinds where they say the same, since a query has room for some hundred indices only.
  const kinds = kindsOf(chains, new Set(chosen));
  const settings = {
    ...(kinds ? { kinds: kinds.join() } : { chains: chosen.join() }),
    ...wave,
    ...timing,
    mode: motion.mode,
    wind: motion.wind?.join(),
    up: motion.up?.join(),
    droop: motion.droop,
    one_sided: motion.one_sided && knowsHead ? true : undefined,
    lift: motion.lift,
    phase_step: phase.step,
    gust_wavelength: phase.gust_wavelength,
    spread: phase.spread,
    seed: phase.seed,
    cycles: phase.cycles,
  };
  return Object.fromEntries(Object.entries(settings).flatMap(([name, value]) => (value == null ? [] : [[name, String(value)]])));
}
