import { DoubleSide, Group, Quaternion, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Plane, PlaneGeometry, BufferGeometry, Float32BufferAttribute, Vector3, type Ray } from "three";

const kHalf = 0.2; // metres of its visible part, on a head of the bundled one's size
const kLines = 8;
const kArm = 0.085; // from the root to the handle
const kHandle = new Vector3(0.62, 0.42, 0.66).normalize(); // from the root to the handle, in the plane's own axes

/** The projection plane of the paper: through the root, turned as one likes. Points are put where the pointer's ray meets it. */
export class DrawPlane {
  readonly group = new Group();
  readonly root = new Vector3();
  readonly normal = new Vector3(0, 0, 1);
  private readonly sheet = new Mesh(new PlaneGeometry(2 * kHalf, 2 * kHalf), new MeshBasicMaterial({ color: "#5a52c4", transparent: true, opacity: 0.13, side: DoubleSide, depthWrite: false }));
  private readonly grid = new LineSegments(DrawPlane.gridGeometry(), new LineBasicMaterial({ color: "#5a52c4", transparent: true, opacity: 0.4, depthWrite: false }));

  constructor() {
    this.group.add(this.sheet, this.grid);
    this.group.renderOrder = 2;
    this.group.visible = false;
  }

  /** Of the head; see headScale. */
  set size(scale: number) {
    this.group.scale.setScalar(scale);
  }

  private get arm(): number {
    return kArm * this.group.scale.x;
  }

  get plane(): Plane {
    return new Plane().setFromNormalAndCoplanarPoint(this.normal, this.root);
  }

  /** Where its handle is: over the plane and to the side, so that it never hides the root. */
  get handle(): Vector3 {
    return kHandle.clone().applyQuaternion(this.group.quaternion).multiplyScalar(this.arm).add(this.root);
  }

  place(root: Vector3, normal: Vector3): void {
    this.root.copy(root);
    this.normal.copy(normal).normalize();
    this.group.position.copy(root);
    this.group.lookAt(root.clone().add(this.normal));
  }

  /** The handle follows a ray on its ball around the root, and the plane with it. */
  turnTo(ray: Ray): void {
    const nearest = ray.closestPointToPoint(this.root, new Vector3());
    const beside = nearest.distanceTo(this.root);
    const back = Math.sqrt(Math.max(0, this.arm * this.arm - beside * beside));
    const wanted = nearest.addScaledVector(ray.direction, -back).sub(this.root).normalize();
    this.turn(new Quaternion().setFromUnitVectors(this.handle.sub(this.root).normalize(), wanted));
  }

  turnBy(axis: Vector3, angle: number): void {
    this.turn(new Quaternion().setFromAxisAngle(axis, angle));
  }

  private turn(by: Quaternion): void {
    this.group.quaternion.premultiply(by);
    this.normal.set(0, 0, 1).applyQuaternion(this.group.quaternion);
  }

  dispose(): void {
    for (const part of [this.sheet, this.grid]) {
      part.geometry.dispose();
      part.material.dispose();
    }
  }

  private static gridGeometry(): BufferGeometry {
    const at = (i: number) => kHalf * ((2 * i) / kLines - 1);
    const ends = Array.from({ length: kLines + 1 }, (_, i) => [at(i), -kHalf, 0, at(i), kHalf, 0, -kHalf, at(i), 0, kHalf, at(i), 0]).flat();
    return new BufferGeometry().setAttribute("position", new Float32BufferAttribute(ends, 3));
  }
}
