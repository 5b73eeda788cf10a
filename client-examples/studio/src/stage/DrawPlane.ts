import { DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, Plane, PlaneGeometry, BufferGeometry, Float32BufferAttribute, Vector3, type Ray } from "three";

const kHalf = 0.2; // metres of its visible part
const kLines = 8;
const kArm = 0.075; // from the root to the handle

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

  get plane(): Plane {
    return new Plane().setFromNormalAndCoplanarPoint(this.normal, this.root);
  }

  /** Where its handle is: at the end of its normal. */
  get handle(): Vector3 {
    return this.root.clone().addScaledVector(this.normal, kArm);
  }

  place(root: Vector3, normal: Vector3): void {
    this.root.copy(root);
    this.normal.copy(normal).normalize();
    this.group.position.copy(root);
    this.group.lookAt(root.clone().add(this.normal));
  }

  /** The handle follows a ray: it stays on a ball around the root. */
  turnTo(ray: Ray): void {
    const nearest = ray.closestPointToPoint(this.root, new Vector3());
    const beside = nearest.distanceTo(this.root);
    const back = Math.sqrt(Math.max(0, kArm * kArm - beside * beside));
    this.place(this.root, nearest.addScaledVector(ray.direction, -back).sub(this.root));
  }

  turnBy(axis: Vector3, angle: number): void {
    this.place(this.root, this.normal.clone().applyAxisAngle(axis, angle));
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
