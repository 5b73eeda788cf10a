import type { HairTones } from "./hairTones";
import { setTones } from "./setTones";
import type { SharedUniforms } from "./sharedUniforms";

/** Paints all tufts that share these uniforms in another color. */
export function setHairTones(shared: SharedUniforms, { tones, shine, line }: HairTones): void {
  setTones({ uniforms: { ramp: shared.ramp } }, tones);
  shared.shine.value.set(shine);
  shared.line.value.set(line);
}
