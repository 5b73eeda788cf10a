import * as THREE from "three";
import { kOutlineFragment, kOutlineVertex } from "./outlineGlsl";

/**
 * An outline by the inverted hull: back faces, pushed out along the smoothed normal by the same number of pixels at every distance.
 * Stage keeps the uniform `pixel`; the geometry needs addSmoothedNormals.
 * @param pixels  width of the line
 * @param behind  metres that it lies behind its surface; what is nearer to its background than that gets no line
 */
export function outlineMaterial(color: string, pixels: number, behind = 0.0018): THREE.ShaderMaterial {
  return new THREE.ShaderMaterial({
    vertexShader: kOutlineVertex,
    fragmentShader: kOutlineFragment,
    side: THREE.BackSide,
    uniforms: {
      line: { value: new THREE.Color(color) },
      pixel: { value: new THREE.Vector2() },
      pixels: { value: pixels },
      behind: { value: behind },
      highlightColor: { value: new THREE.Color("#ffffff") },
      highlight: { value: 0 },
      opacity: { value: 1 },
    },
  });
}
