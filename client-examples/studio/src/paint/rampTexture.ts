import * as THREE from "three";

/** Tones side by side, one texel each. @param tones  CSS colors, darkest first */
export function rampTexture(tones: readonly string[]): THREE.DataTexture {
  const data = new Uint8Array(tones.flatMap((tone) => [...new THREE.Color(tone).toArray().map((part) => Math.round(255 * part)), 255]));
  const texture = new THREE.DataTexture(data, tones.length, 1);
  texture.minFilter = texture.magFilter = THREE.NearestFilter;
  texture.needsUpdate = true;
  return texture;
}
