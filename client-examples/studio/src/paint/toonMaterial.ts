import * as THREE from "three";
import { rampTexture } from "./rampTexture";
import { kToonFragment, kToonVertex } from "./toonGlsl";

/** A picture laid on from the front (+Z), in the world's frame, metres. Whoever made the texture disposes of it. */
export interface Decal {
  readonly texture: THREE.Texture;
  /** Left, bottom, right, top. */
  readonly box: readonly [number, number, number, number];
  /** What lies farther back than this z gets none. */
  readonly front: number;
}

export interface ToonOptions {
  /** Three CSS colors, darkest first. */
  readonly tones: readonly string[];
  /** Color of the band of light. */
  readonly shine?: string;
  /** The band's height on the head (sine of the elevation) and half its width; width 0 is none. */
  readonly band?: readonly [number, number];
  /** How much of the normal is the head's, not the surface's own, 0..1. */
  readonly roundness?: number;
  /** Of the head, world space. */
  readonly center?: readonly [number, number, number];
  readonly decal?: Decal;
  /** Multiplies the tones; drawn where its alpha is over one half. The caller disposes of it. */
  readonly map?: THREE.Texture;
  /** Towards the light: right, up, towards the eye. */
  readonly light?: readonly [number, number, number];
  readonly side?: THREE.Side;
}

/**
 * Flat shading in three tones, as a cel painter mixes them, and a band of light on hair. Receives shadows; skinned meshes are posed.
 * The light keeps its place before the eye in every view. Free it with dispose(), and its ramp with `uniforms.ramp.value.dispose()`.
 */
export function toonMaterial(options: ToonOptions): THREE.ShaderMaterial {
  const { tones, shine = "#ffffff", band = [0, 0], roundness = 0, center = [0, 0, 0], decal, map } = options;
  const { light = [0.45, 0.8, 0.6], side = THREE.FrontSide } = options;
  const defines: Record<string, string> = {};
  const uniforms: Record<string, THREE.IUniform> = {
    ...THREE.UniformsUtils.clone(THREE.UniformsLib.lights),
    ramp: { value: rampTexture(tones) },
    light: { value: new THREE.Vector3(...light) },
    roundness: { value: roundness },
    center: { value: new THREE.Vector3(...center) },
    shine: { value: new THREE.Color(shine) },
    band: { value: new THREE.Vector2(...band) },
    highlightColor: { value: new THREE.Color("#ffffff") },
    highlight: { value: 0 },
    opacity: { value: 1 },
  };
  if (decal) {
    defines["DECAL"] = "";
    uniforms["decal"] = { value: decal.texture };
    uniforms["decalBox"] = { value: new THREE.Vector4(...decal.box) };
    uniforms["decalFront"] = { value: decal.front };
  }
  if (map) {
    map.updateMatrix();
    defines["MAPPED"] = "";
    uniforms["map"] = { value: map };
    uniforms["mapTransform"] = { value: map.matrix };
  }
  return new THREE.ShaderMaterial({ vertexShader: kToonVertex, fragmentShader: kToonFragment, lights: true, defines, uniforms, side });
}
