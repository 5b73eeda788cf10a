import * as THREE from "three";
import type { HairTones } from "./hairTones";
import type { PoseTexture, PoseUniforms } from "./PoseTexture";
import { rampTexture } from "./rampTexture";

/** Uniforms of all tufts of one head of hair: a new value in one of them changes every tuft. */
export interface SharedUniforms extends PoseUniforms {
  readonly ramp: THREE.IUniform<THREE.DataTexture>;
  readonly shine: THREE.IUniform<THREE.Color>;
  readonly line: THREE.IUniform<THREE.Color>;
  /** See toonMaterial. */
  readonly band: THREE.IUniform<THREE.Vector2>;
  readonly roundness: THREE.IUniform<number>;
  /** Of the head, metres. */
  readonly center: THREE.IUniform<THREE.Vector3>;
  readonly light: THREE.IUniform<THREE.Vector3>;
  readonly highlightColor: THREE.IUniform<THREE.Color>;
  /** Size of a pixel in clip space; Stage sets it. */
  readonly pixel: THREE.IUniform<THREE.Vector2>;
  /** Width of the outline. */
  readonly pixels: THREE.IUniform<number>;
  readonly behind: THREE.IUniform<number>;
}

const kHair = { band: [0.62, 0.085], roundness: 0.45, light: [0.45, 0.8, 0.6], pixels: 1.3, behind: 0.0018 } as const;

/**
 * What tuftMaterials shares. For ghosts at another picture, take `{ ...shared, picture: { value: j } }`.
 * The ramp is to be disposed of by the caller: `shared.ramp.value.dispose()`.
 * @param center  of the head, metres
 */
export function sharedUniforms(poses: PoseTexture, tones: HairTones, center: readonly [number, number, number] = [0, 0, 0]): SharedUniforms {
  return {
    ...poses.uniforms,
    ramp: { value: rampTexture(tones.tones) },
    shine: { value: new THREE.Color(tones.shine) },
    line: { value: new THREE.Color(tones.line) },
    band: { value: new THREE.Vector2(...kHair.band) },
    roundness: { value: kHair.roundness },
    center: { value: new THREE.Vector3(...center) },
    light: { value: new THREE.Vector3(...kHair.light) },
    highlightColor: { value: new THREE.Color("#e8638c") },
    pixel: { value: new THREE.Vector2() },
    pixels: { value: kHair.pixels },
    behind: { value: kHair.behind },
  };
}
