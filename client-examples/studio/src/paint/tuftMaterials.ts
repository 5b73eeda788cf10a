import * as THREE from "three";
import { kOutlineFragment, kOutlineVertex } from "./outlineGlsl";
import { kPosingGlsl } from "./posingGlsl";
import type { SharedUniforms } from "./sharedUniforms";
import { kToonFragment, kToonVertex } from "./toonGlsl";

/** What tufts are painted with. Their geometry has the attributes position, normal, smoothed, joints, weights and mark. */
export interface TuftMaterials {
  readonly toon: THREE.ShaderMaterial;
  /** For the hull; see outlineOf. */
  readonly outline: THREE.ShaderMaterial;
  /** For `mesh.customDepthMaterial`: the shadow of what is posed; none while it is not solid. */
  readonly depth: THREE.ShaderMaterial;
  /** Writes depth and no color, before the rest: what is not solid shows only its nearest surface. Invisible while it is solid. */
  readonly veil: THREE.ShaderMaterial;
  /** 1 is solid; below it, a ghost. */
  opacity: number;
  dispose(): void;
}

const kDepthVertex = /* glsl */ `
  #include <common>
  ${kPosingGlsl}
  uniform float opacity;
  uniform bool shadow;
  invariant gl_Position; // the veil is exactly where the surface is
  void main() {
    #include <begin_vertex>
    #ifdef POSED
      transformed = (poseMatrix() * vec4(transformed, 1.0)).xyz;
    #endif
    #include <project_vertex>
    if (shadow && opacity < 1.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside
  }`;
const kDepthFragment = "void main() { gl_FragColor = vec4(1.0); }";

/** Materials for tufts that are posed on the graphics card. @param shared  is not disposed of */
export function tuftMaterials(shared: SharedUniforms): TuftMaterials {
  const opacity = { value: 1 };
  const { poses, poseJoints, posePictures, picture, ramp, shine, line, band, roundness, center, light, highlightColor } = shared;
  const posing = { poses, poseJoints, posePictures, picture, opacity };
  const defines = { POSED: "" };
  const toon = new THREE.ShaderMaterial({
    vertexShader: kToonVertex,
    fragmentShader: kToonFragment,
    lights: true,
    defines,
    uniforms: {
      ...THREE.UniformsUtils.clone(THREE.UniformsLib.lights),
      ...posing,
      ...{ ramp, shine, band, roundness, center, light, highlightColor },
    },
  });
  const outline = new THREE.ShaderMaterial({
    vertexShader: kOutlineVertex,
    fragmentShader: kOutlineFragment,
    side: THREE.BackSide,
    defines,
    uniforms: { ...posing, highlightColor, line, pixel: shared.pixel, pixels: shared.pixels, behind: shared.behind },
  });
  const plain = { vertexShader: kDepthVertex, fragmentShader: kDepthFragment, defines };
  const depth = new THREE.ShaderMaterial({ ...plain, uniforms: { ...posing, shadow: { value: true } } });
  const veil = new THREE.ShaderMaterial({
    ...plain,
    uniforms: { ...posing, shadow: { value: false } },
    transparent: true, // drawn among what is not solid
    colorWrite: false,
    visible: false,
  });
  return {
    toon,
    outline,
    depth,
    veil,
    get opacity() {
      return opacity.value;
    },
    set opacity(value: number) {
      opacity.value = value;
      const solid = value >= 1;
      if (veil.visible !== solid) return;
      veil.visible = !solid;
      for (const material of [toon, outline]) {
        material.transparent = !solid;
        material.needsUpdate = true;
      }
    },
    dispose() {
      for (const material of [toon, outline, depth, veil]) material.dispose();
    },
  };
}
