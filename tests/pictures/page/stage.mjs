// One renderer for all pictures: lights, camera, and a drawing brought down from several times its size.
import * as THREE from "three";

THREE.ColorManagement.enabled = false; // colors are what the painter mixed

const kOversampling = 3;
let renderer = null;

function rendererFor(width, height) {
  if (!renderer) {
    renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    renderer.setClearColor("#000000", 0);
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = THREE.BasicShadowMap;
  }
  renderer.setSize(width, height, false);
  return renderer;
}

/** An empty scene with a light that casts shadows around `center`. */
export function makeStage({ center = [0, 0, 0], radius = 0.3 } = {}) {
  const scene = new THREE.Scene();
  const sun = new THREE.DirectionalLight("#ffffff", 1);
  const middle = new THREE.Vector3(...center);
  sun.target.position.copy(middle);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  Object.assign(sun.shadow.camera, { left: -radius, right: radius, top: radius, bottom: -radius, near: 0.5, far: 4 });
  sun.shadow.normalBias = 0.006;
  sun.shadow.bias = -0.001;
  scene.add(sun, sun.target);
  scene.userData.sun = sun;
  return scene;
}

/** A camera that looks at `at` from `azimuth_deg` right of the front and `elevation_deg` above; `height` metres fill the picture. */
export function makeCamera({ at, azimuth_deg, elevation_deg = 0, height }) {
  const camera = new THREE.PerspectiveCamera(18, 1, 0.1, 20);
  const distance = height / 2 / Math.tan((camera.fov * Math.PI) / 360);
  const direction = new THREE.Vector3().setFromSphericalCoords(distance, ((90 - elevation_deg) * Math.PI) / 180, (azimuth_deg * Math.PI) / 180);
  camera.position.set(...at).add(direction);
  camera.lookAt(...at);
  return camera;
}

/** From right, up and towards the eye to a direction in the scene, so that the lit side is the same in every view. */
function asSeenBy(camera, [right, up, towards]) {
  const axes = [0, 1, 2].map((i) => new THREE.Vector3().setFromMatrixColumn(camera.matrixWorld, i));
  return new THREE.Vector3().addScaledVector(axes[0], right).addScaledVector(axes[1], up).addScaledVector(axes[2], towards).normalize();
}

const kSun = [0.45, 0.6, 0.85]; // casts the shadows: low, so that a fringe leaves the eyes in the light

/** Draws the scene into a rectangle of a 2D canvas. */
export function drawScene(context, scene, camera, { x, y, width, height }) {
  const target = rendererFor(width * kOversampling, height * kOversampling);
  camera.aspect = width / height;
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
  const { sun } = scene.userData;
  sun.position.copy(sun.target.position).addScaledVector(asSeenBy(camera, kSun), 2);
  scene.traverse(({ material }) => {
    if (material?.userData?.light) material.uniforms.light.value.copy(asSeenBy(camera, material.userData.light));
    const pixels = material?.userData?.pixels;
    if (pixels) material.uniforms.pixel.value.set((2 * pixels) / width, (2 * pixels) / height);
  });
  target.render(scene, camera);
  if (target.getContext().isContextLost()) throw new Error("the WebGL context was lost");
  context.imageSmoothingQuality = "high";
  context.drawImage(target.domElement, x, y, width, height);
}

/** Frees what a scene put on the graphics card. */
export function disposeStage(scene) {
  scene.traverse((node) => {
    node.geometry?.dispose();
    node.material?.uniforms?.ramp?.value.dispose();
    node.material?.dispose();
    node.skeleton?.dispose();
  });
}
