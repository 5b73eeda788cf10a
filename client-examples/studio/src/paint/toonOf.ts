import * as THREE from "three";
import type { BaseColor } from "./baseColorOf";
import { colorParts } from "./colorParts";
import { kSkin } from "./skinPaint";
import { scaleColor } from "./scaleColor";
import { skinTones } from "./skinTones";
import { toonMaterial } from "./toonMaterial";

const kTints = ["#c3aebf", "#dfd0da", "#ffffff"] as const; // multiply a picture

/**
 * A material's base color in three tones, its picture kept. Disposing of the material does not dispose of its ramp and its picture:
 * both are uniforms, `ramp` and `map`.
 * @param isSkin  paint it like skin, whatever its color
 */
export function toonOf({ map, color, side }: BaseColor, isSkin: boolean): THREE.ShaderMaterial {
  const { light } = kSkin;
  if (!map) return toonMaterial({ tones: isSkin ? kSkin.tones : skinTones(color), light, side });
  const shown = map.clone(); // as the file has its bytes: without a change of color space
  shown.colorSpace = THREE.NoColorSpace;
  return toonMaterial({ tones: kTints.map((tint) => scaleColor(tint, colorParts(color))), light, side, map: shown });
}
