import { kPosingGlsl } from "./posingGlsl";

export const kOutlineVertex = /* glsl */ `
  #include <common>
  #include <skinning_pars_vertex>
  ${kPosingGlsl}
  uniform vec2 pixel;      // the size of one in clip space
  uniform float pixels;    // width of the line
  uniform float behind;    // metres that the line lies behind its surface; what is nearer to its background than that gets none
  uniform float highlight;
  varying float vHighlight;
  attribute vec3 smoothed;
  void main() {
    vec3 objectNormal = smoothed;
    #include <begin_vertex>
    #ifdef POSED
      mat4 pose = poseMatrix();
      objectNormal = mat3(pose) * objectNormal;
      transformed = (pose * vec4(transformed, 1.0)).xyz;
    #endif
    #include <skinbase_vertex>
    #include <skinnormal_vertex>
    vec3 transformedNormal = normalMatrix * objectNormal;
    #include <skinning_vertex>
    #include <project_vertex>
    vec2 away = (projectionMatrix * vec4(transformedNormal, 0.0)).xy;
    float size = length(away);
    #ifdef POSED
      vHighlight = mark;
    #else
      vHighlight = highlight;
    #endif
    float width = pixels * (1.0 + 0.6 * vHighlight);
    if (size > 1e-6) gl_Position.xy += away / size * pixel * width * gl_Position.w * min(1.0, length(transformedNormal.xy) * 3.0);
    vec4 pushed = projectionMatrix * (mvPosition - vec4(0.0, 0.0, behind, 0.0));
    gl_Position.z = pushed.z / pushed.w * gl_Position.w;
  }`;

export const kOutlineFragment = /* glsl */ `
  uniform vec3 line;
  uniform vec3 highlightColor;
  varying float vHighlight;
  uniform float opacity;
  void main() {
    gl_FragColor = vec4(mix(line, highlightColor, vHighlight), opacity);
  }`;
