// The inverted hull: back faces, pushed out along the skinned normal by the same number of pixels at every distance.
import * as THREE from "three";

const vertexShader = /* glsl */ `
  #include <common>
  #include <skinning_pars_vertex>
  uniform vec2 pixel;   // width of the line in clip space
  uniform float behind; // metres that the line lies behind its surface; what is nearer to its background than that gets none
  attribute vec3 smoothed;
  void main() {
    vec3 objectNormal = smoothed;
    #include <skinbase_vertex>
    #include <skinnormal_vertex>
    vec3 transformedNormal = normalMatrix * objectNormal;
    #include <begin_vertex>
    #include <skinning_vertex>
    #include <project_vertex>
    vec2 away = (projectionMatrix * vec4(transformedNormal, 0.0)).xy;
    float size = length(away);
    if (size > 1e-6) gl_Position.xy += away / size * pixel * gl_Position.w * min(1.0, length(transformedNormal.xy) * 3.0);
    vec4 pushed = projectionMatrix * (mvPosition - vec4(0.0, 0.0, behind, 0.0));
    gl_Position.z = pushed.z / pushed.w * gl_Position.w;
  }`;

/** Normals averaged over vertices at one place: at a cap's rim and a texture's seam the hull must not tear. */
export function addSmoothedNormals(geometry) {
  if (geometry.getAttribute("smoothed")) return;
  const { position, normal } = geometry.attributes;
  const sums = new Map();
  const key = (i) => `${Math.round(position.getX(i) * 1e6)},${Math.round(position.getY(i) * 1e6)},${Math.round(position.getZ(i) * 1e6)}`;
  for (let i = 0; i < position.count; i++) {
    const sum = sums.get(key(i)) ?? [0, 0, 0];
    sums.set(key(i), [sum[0] + normal.getX(i), sum[1] + normal.getY(i), sum[2] + normal.getZ(i)]);
  }
  const smoothed = new Float32Array(3 * position.count);
  for (let i = 0; i < position.count; i++) smoothed.set(new THREE.Vector3(...sums.get(key(i))).normalize().toArray(), 3 * i);
  geometry.setAttribute("smoothed", new THREE.BufferAttribute(smoothed, 3));
}

export function outlineMaterial(color, pixels, behind = 0.0018) {
  const material = new THREE.ShaderMaterial({
    vertexShader,
    fragmentShader: "uniform vec3 color; void main() { gl_FragColor = vec4(color, 1.0); }",
    side: THREE.BackSide,
    uniforms: { color: { value: new THREE.Color(color) }, pixel: { value: new THREE.Vector2() }, behind: { value: behind } },
  });
  material.userData.pixels = pixels;
  return material;
}

/** The hull of a mesh, skinned or not, to hang beside it. */
export function outlineOf(mesh, material) {
  addSmoothedNormals(mesh.geometry);
  const hull = mesh.isSkinnedMesh ? new THREE.SkinnedMesh(mesh.geometry, material) : new THREE.Mesh(mesh.geometry, material);
  if (mesh.isSkinnedMesh) hull.bind(mesh.skeleton, mesh.bindMatrix);
  hull.applyMatrix4(mesh.matrix);
  hull.frustumCulled = false;
  return hull;
}
