import * as THREE from "three";

/** Gives a camera the proportions of its picture; what it shows from bottom to top stays. @param aspect  width / height */
export function fitCamera(camera: THREE.PerspectiveCamera | THREE.OrthographicCamera, aspect: number): void {
  if (camera instanceof THREE.PerspectiveCamera) {
    camera.aspect = aspect;
  } else {
    const half = ((camera.top - camera.bottom) / 2) * aspect;
    const middle = (camera.left + camera.right) / 2;
    Object.assign(camera, { left: middle - half, right: middle + half });
  }
  camera.updateProjectionMatrix();
}
