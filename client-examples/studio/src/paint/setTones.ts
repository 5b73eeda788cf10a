import type * as THREE from "three";
import { rampTexture } from "./rampTexture";

/** Mixes other tones for a toon material, or for all that share its ramp. @param tones  three CSS colors, darkest first */
export function setTones({ uniforms }: { readonly uniforms: { readonly [name: string]: THREE.IUniform } }, tones: readonly string[]): void {
  const ramp = uniforms["ramp"] as THREE.IUniform<THREE.DataTexture> | undefined;
  if (!ramp) throw new Error("this material has no ramp");
  ramp.value.dispose();
  ramp.value = rampTexture(tones);
}
