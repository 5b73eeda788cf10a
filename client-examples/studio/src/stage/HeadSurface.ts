import { Matrix3, Mesh, Raycaster, Vector3, type Ray } from "three";
import { MeshBVH, acceleratedRaycast } from "three-mesh-bvh";

export interface Hit {
  readonly point: Vector3;
  /** Outward, unit. */
  readonly normal: Vector3;
}

/** The head as something to draw on. */
export class HeadSurface {
  private readonly raycaster = new Raycaster();

  /** @param mesh  in the scene's frame; keeps a search tree in its geometry */
  constructor(private readonly mesh: Mesh) {
    mesh.geometry.boundsTree = new MeshBVH(mesh.geometry);
    mesh.raycast = acceleratedRaycast;
    this.raycaster.firstHitOnly = true;
  }

  /** Where a ray first meets the head; null is beside it. */
  hit(ray: Ray): Hit | null {
    this.raycaster.ray.copy(ray);
    const [first] = this.raycaster.intersectObject(this.mesh, false);
    if (!first?.face) return null;
    const normal = first.face.normal.clone().applyNormalMatrix(new Matrix3().getNormalMatrix(this.mesh.matrixWorld));
    return { point: first.point, normal: normal.dot(ray.direction) > 0 ? normal.negate() : normal };
  }
}
