import { kPosingGlsl } from "./posingGlsl";

export const kToonVertex = /* glsl */ `
  #include <common>
  #include <skinning_pars_vertex>
  #include <shadowmap_pars_vertex>
  ${kPosingGlsl}
  varying vec3 vNormal;  // view space
  varying vec3 vView;
  varying vec3 vModel;   // world space
  varying vec3 vModelNormal;
  uniform float highlight; // 0 to 1
  varying float vHighlight;
  #ifdef MAPPED
    uniform mat3 mapTransform;
    varying vec2 vAt;
  #endif
  invariant gl_Position;
  void main() {
    #include <beginnormal_vertex>
    #include <begin_vertex>
    #ifdef POSED
      mat4 pose = poseMatrix();
      objectNormal = mat3(pose) * objectNormal;
      transformed = (pose * vec4(transformed, 1.0)).xyz;
    #endif
    #include <skinbase_vertex>
    #include <skinnormal_vertex>
    #include <defaultnormal_vertex>
    #include <skinning_vertex>
    #include <project_vertex>
    #include <worldpos_vertex>
    #include <shadowmap_vertex>
    #ifdef POSED
      vHighlight = mark;
    #else
      vHighlight = highlight;
    #endif
    vNormal = transformedNormal;
    vModelNormal = inverseTransformDirection(transformedNormal, viewMatrix);
    vModel = (modelMatrix * vec4(transformed, 1.0)).xyz;
    vView = mvPosition.xyz;
    #ifdef MAPPED
      vAt = (mapTransform * vec3(uv, 1.0)).xy;
    #endif
  }`;

// Edges between tones are drawn one pixel soft, by how fast a value changes across the screen: so they stay clean while a head turns.
export const kToonFragment = /* glsl */ `
  #include <common>
  #include <bsdfs>
  #include <lights_pars_begin>
  #include <shadowmap_pars_fragment>
  #include <shadowmask_pars_fragment>
  uniform sampler2D ramp;
  uniform vec3 light;          // towards the light: right, up, towards the eye
  uniform float roundness;     // how much of the normal is the head's, not the tuft's
  uniform vec3 center;         // of the head
  uniform vec3 shine;          // color of the band
  uniform vec2 band;           // its height on the head (sine) and half its width; width 0 is none
  uniform vec3 highlightColor;
  varying float vHighlight;
  uniform float opacity;
  #ifdef DECAL
    uniform sampler2D decal;   // laid on from the front
    uniform vec4 decalBox;     // left, bottom, right, top, metres
    uniform float decalFront;  // what lies behind that (z, metres) gets none
  #endif
  #ifdef MAPPED
    uniform sampler2D map;
    varying vec2 vAt;
  #endif
  varying vec3 vNormal;
  varying vec3 vView;
  varying vec3 vModel;
  varying vec3 vModelNormal;

  float edge(float at, float value) {
    return clamp((value - at) / clamp(fwidth(value), 1e-5, 0.04) + 0.5, 0.0, 1.0);
  }

  vec3 toneAt(float lit, float sun) {
    vec3 dark = texelFetch(ramp, ivec2(0, 0), 0).rgb;
    vec3 middle = texelFetch(ramp, ivec2(1, 0), 0).rgb;
    vec3 light = texelFetch(ramp, ivec2(2, 0), 0).rgb;
    return mix(mix(dark, middle, edge(1.0 / 3.0, lit)), light, sun * edge(2.0 / 3.0, lit));
  }

  void main() {
    vec3 own = normalize(vModelNormal);
    vec3 head = normalize(vModel - center);
    vec3 n = normalize(mix(own, head, roundness));
    float lit = 0.5 + 0.5 * dot((viewMatrix * vec4(n, 0.0)).xyz, normalize(light));
    float sun = getShadowMask();
    vec3 color = toneAt(lit, sun); // in a shadow, no light
    float bright = sun * edge(0.45, lit);
    #ifdef MAPPED
      vec4 own_color = texture2D(map, vAt);
      if (own_color.a < 0.5) discard;
      color *= own_color.rgb;
    #endif
    // The band is widest where a tuft faces the eye and runs out at its edges, so that it breaks up into strokes.
    vec3 eye = isOrthographic ? vec3(0.0, 0.0, 1.0) : normalize(-vView);
    float facing = clamp(dot(normalize(vNormal), eye), 0.0, 1.0);
    float height = dot(normalize(mix(own, head, 0.72)), vec3(0.0, 1.0, 0.0));
    float width = band.y * smoothstep(0.55, 1.0, facing);
    float inside = edge(0.0, width - abs(height - band.x));
    if (width > 0.0) color = mix(color, shine, inside * bright);
    #ifdef DECAL
      vec2 at = (vModel.xy - decalBox.xy) / (decalBox.zw - decalBox.xy);
      vec4 drawn = texture2D(decal, at);
      if (own.z > 0.35 && vModel.z > decalFront && at == clamp(at, 0.0, 1.0)) color = mix(color, drawn.rgb * mix(0.86, 1.0, bright), drawn.a);
    #endif
    // Half of the accent: the tones must stay readable.
    color = mix(color, highlightColor, 0.5 * vHighlight);
    gl_FragColor = vec4(color, opacity);
  }`;
