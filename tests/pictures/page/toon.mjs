// Flat shading in three tones, as a cel painter mixes them, and a band of light on hair.
import * as THREE from "three";

const vertexShader = /* glsl */ `
  #include <common>
  #include <skinning_pars_vertex>
  #include <shadowmap_pars_vertex>
  varying vec3 vNormal;
  varying vec3 vModel;
  varying vec3 vView;
  varying vec3 vModelNormal;
  void main() {
    #include <beginnormal_vertex>
    #include <skinbase_vertex>
    #include <skinnormal_vertex>
    #include <defaultnormal_vertex>
    #include <begin_vertex>
    #include <skinning_vertex>
    #include <project_vertex>
    #include <worldpos_vertex>
    #include <shadowmap_vertex>
    vNormal = transformedNormal;
    vModelNormal = inverseTransformDirection(transformedNormal, viewMatrix);
    vModel = (modelMatrix * vec4(transformed, 1.0)).xyz;
    vView = mvPosition.xyz;
  }`;

const fragmentShader = /* glsl */ `
  #include <common>
  #include <bsdfs>
  #include <lights_pars_begin>
  #include <shadowmap_pars_fragment>
  #include <shadowmask_pars_fragment>
  uniform sampler2D ramp;
  uniform vec3 light;          // towards the light, world space
  uniform float roundness;     // how much of the normal is the head's, not the tuft's
  uniform vec3 center;         // of the head
  uniform vec3 shine;          // color of the band
  uniform vec2 band;           // its height on the head (sine) and half its width; width 0 is none
  uniform sampler2D decal;     // laid on from the front
  uniform vec4 decalBox;       // left, bottom, right, top, metres
  varying vec3 vNormal;
  varying vec3 vModel;
  varying vec3 vView;
  varying vec3 vModelNormal;
  void main() {
    vec3 own = normalize(vModelNormal);
    vec3 head = normalize(vModel - center);
    vec3 n = normalize(mix(own, head, roundness));
    float lit = 0.5 + 0.5 * dot(n, normalize(light));
    lit = min(lit, mix(0.4, 1.0, step(0.5, getShadowMask())));
    vec3 color = texture2D(ramp, vec2(lit, 0.5)).rgb;
    // The band is widest where a tuft faces the eye and runs out at its edges, so that it breaks up into strokes.
    float facing = clamp(dot(normalize(vNormal), normalize(-vView)), 0.0, 1.0);
    float height = dot(normalize(mix(own, head, 0.72)), vec3(0.0, 1.0, 0.0));
    float width = band.y * smoothstep(0.55, 1.0, facing);
    if (abs(height - band.x) < width && lit > 0.45) color = shine;
    vec2 at = (vModel.xy - decalBox.xy) / (decalBox.zw - decalBox.xy);
    if (own.z > 0.35 && vModel.z > center.z && at == clamp(at, 0.0, 1.0)) {
      vec4 drawn = texture2D(decal, at);
      color = mix(color, drawn.rgb * (lit > 0.45 ? 1.0 : 0.86), drawn.a);
    }
    gl_FragColor = vec4(color, 1.0);
  }`;

function rampTexture(colors) {
  const data = new Uint8Array(colors.flatMap((color) => [...new THREE.Color(color).toArray().map((x) => Math.round(255 * x)), 255]));
  const texture = new THREE.DataTexture(data, colors.length, 1);
  texture.minFilter = texture.magFilter = THREE.NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** Mixes other tones for a material. */
export function setTones(material, tones) {
  material.uniforms.ramp.value.dispose();
  material.uniforms.ramp.value = rampTexture(tones);
}

/** @param tones  three colors, darkest first
 *  @param light  towards the light that tones are painted by: right, up, towards the eye */
export function toonMaterial({ tones, shine = "#ffffff", band = [0, 0], roundness = 0, center = [0, 0, 0], decal = null, light = [0.45, 0.8, 0.6] }) {
  const material = new THREE.ShaderMaterial({
    vertexShader,
    fragmentShader,
    lights: true,
    uniforms: {
      ...THREE.UniformsUtils.clone(THREE.UniformsLib.lights),
      ramp: { value: rampTexture(tones) },
      light: { value: new THREE.Vector3(0, 1, 0) },
      roundness: { value: roundness },
      center: { value: new THREE.Vector3(...center) },
      shine: { value: new THREE.Color(shine) },
      band: { value: new THREE.Vector2(...band) },
      decal: { value: decal?.texture ?? null },
      decalBox: { value: new THREE.Vector4(...(decal?.box ?? [9, 9, 9.1, 9.1])) }, // nowhere
    },
  });
  material.userData.light = light;
  return material;
}
