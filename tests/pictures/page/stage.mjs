// The studio's stage, on which one scene after the other is drawn.
import * as THREE from "three";
import { Stage } from "../../../client-examples/studio/src/paint/Stage";

const kOversampling = 6; // lines of a little over a pixel: with fewer samples, steps and gaps are seen in them
const stage = new Stage(document.createElement("canvas"));

/** An empty scene. @param center, radius  of the ball in which shadows are cast, metres */
export function makeScene({ center = [0, 0, 0], radius = 0.3 } = {}) {
  const scene = new THREE.Group();
  scene.userData.lit = [center, radius];
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

/** Draws the scene into a rectangle of a 2D canvas. */
export function drawScene(context, scene, camera, { x, y, width, height }) {
  stage.lightUp(...scene.userData.lit);
  stage.scene.add(scene);
  context.drawImage(stage.snapshot(camera, width, height, kOversampling), x, y);
  stage.scene.remove(scene);
}

/** Frees what a scene put on the graphics card. */
export function disposeScene(scene) {
  scene.traverse((node) => {
    node.geometry?.dispose();
    for (const name of ["ramp", "decal"]) node.material?.uniforms?.[name]?.value.dispose();
    node.material?.dispose();
    node.skeleton?.dispose();
  });
}
