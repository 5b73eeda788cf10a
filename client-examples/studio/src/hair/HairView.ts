import { Group, Mesh, Raycaster, type BufferGeometry, type Ray } from "three";
import { MeshBVH, acceleratedRaycast } from "three-mesh-bvh";
import type { HeadBall } from "../model/HeadBall";
import { hairTones } from "../paint/hairTones";
import { PoseTexture } from "../paint/PoseTexture";
import { setHairTones } from "../paint/setHairTones";
import { sharedUniforms } from "../paint/sharedUniforms";
import type { LoadedHair } from "./HairLoader";
import { markTufts } from "./markTufts";
import { mergedTufts, type TuftPart } from "./mergedTufts";
import { StrokeLines } from "./StrokeLines";
import { tuftGeometry } from "./tuftGeometry";
import type { TuftMesh } from "./TuftMesh";
import { TuftSet } from "./TuftSet";

/** A tuft for rays to hit. */
interface Pickable extends TuftPart {
  readonly id: number;
  readonly mesh: Mesh;
}

const kGhost = 0.22; // opacity of the pictures before and after
const kRest = -1; // as a picture
const kLineBehind = 0.018; // of the head's radius; see outlineMaterial
const kHovered = 0.25;
const kSelected = 0.45;

/** The hair in the scene: at rest or in a picture of its cycle, with its neighbors as ghosts, or in smooth motion. */
export class HairView {
  readonly group = new Group();
  private readonly limitedPoses = new PoseTexture();
  private readonly smoothPoses = new PoseTexture();
  private readonly limitedPaint;
  private readonly smoothPaint;
  private readonly beforePaint;
  private readonly afterPaint;
  private readonly limited: TuftSet;
  private readonly smooth: TuftSet;
  private readonly before: TuftSet;
  private readonly after: TuftSet;
  private readonly strokes = new StrokeLines();
  /** Of each tuft for itself; never drawn. */
  private readonly geometries = new WeakMap<TuftMesh, BufferGeometry>();
  private tufts: readonly Pickable[] = [];
  private merged: BufferGeometry | null = null;
  private pictures = 0;
  private hasSmooth = false;
  private hoveredId: number | null = null;
  private selectedIds: readonly number[] = [];
  private readonly raycaster = new Raycaster();

  constructor(color: string) {
    const tones = hairTones(color);
    this.limitedPaint = sharedUniforms(this.limitedPoses, tones);
    this.smoothPaint = { ...this.limitedPaint, ...this.smoothPoses.uniforms };
    this.beforePaint = { ...this.limitedPaint, picture: { value: kRest } };
    this.afterPaint = { ...this.limitedPaint, picture: { value: kRest } };
    this.limited = new TuftSet(this.limitedPaint);
    this.smooth = new TuftSet(this.smoothPaint);
    this.before = new TuftSet(this.beforePaint, kGhost);
    this.after = new TuftSet(this.afterPaint, kGhost);
    this.group.add(this.limited.group, this.smooth.group, this.before.group, this.after.group, this.strokes.group);
    this.strokes.setColor(tones.line);
    this.raycaster.firstHitOnly = true;
  }

  /** Another head of hair, or another state of it. */
  show({ tufts, meshes, unmeshed, limited, smooth }: LoadedHair): void {
    this.strokes.show(unmeshed);
    this.tufts = meshes.map((mesh, i) => {
      const geometry = this.geometryOf(mesh);
      return { id: tufts[i]!.id, geometry, joints: mesh.rest.length / 3, mesh: new Mesh(geometry) };
    });
    this.merged?.dispose();
    this.merged = meshes.length > 0 ? mergedTufts(this.tufts) : null;
    this.limited.show(this.merged);
    this.limitedPoses.set(limited?.pictures ?? 0, limited?.joints ?? 0, limited?.matrices ?? new Float32Array());
    this.smoothPoses.set(smooth?.pictures ?? 0, smooth?.joints ?? 0, smooth?.matrices ?? new Float32Array());
    this.pictures = limited?.pictures ?? 0;
    this.hasSmooth = smooth !== null;
    for (const set of [this.smooth, this.before, this.after]) set.show(null);
    this.paintHighlights();
  }

  setColor(color: string): void {
    const tones = hairTones(color);
    setHairTones(this.limitedPaint, tones);
    this.strokes.setColor(tones.line);
  }

  /** The head that the hair is on. */
  setHead({ center, radius }: HeadBall): void {
    this.limitedPaint.center.value.set(...center);
    this.limitedPaint.behind.value = kLineBehind * radius;
  }

  /** A still of the cycle; null is the hair at rest. @param onion  whether the one before and the one after shine through */
  showPicture(picture: number | null, onion: boolean): void {
    const isMoving = picture !== null && this.pictures > 0;
    this.limitedPaint.picture.value = isMoving ? picture % this.pictures : kRest;
    this.limited.group.visible = true;
    this.smooth.group.visible = false;
    const ghosts = isMoving && onion && this.pictures > 1;
    for (const [set, paint, step] of [[this.before, this.beforePaint, -1], [this.after, this.afterPaint, 1]] as const) {
      set.show(ghosts ? this.merged : null);
      paint.picture.value = isMoving ? (picture + step + this.pictures) % this.pictures : kRest;
    }
  }

  /** The motion as it would be without holds. @param part  of the cycle, 0..1 */
  showSmooth(part: number): void {
    this.smooth.show(this.merged);
    this.smoothPoses.uniforms.picture.value = this.hasSmooth ? part * this.smoothPoses.uniforms.posePictures.value : kRest;
    this.limited.group.visible = false;
    this.smooth.group.visible = true;
    for (const set of [this.before, this.after]) set.show(null);
  }

  get hovered(): number | null {
    return this.hoveredId;
  }

  set hovered(id: number | null) {
    this.hoveredId = id;
    this.paintHighlights();
  }

  set selected(ids: readonly number[]) {
    this.selectedIds = ids;
    this.paintHighlights();
  }

  /** The id of the tuft that a ray meets first, at rest. */
  tuftAt(ray: Ray): number | null {
    this.raycaster.ray.copy(ray);
    let nearest: number | null = null;
    let closest = Infinity;
    for (const { id, mesh } of this.tufts) {
      mesh.geometry.boundsTree ??= new MeshBVH(mesh.geometry, { indirect: true }); // tufts of equal make share their indices
      mesh.raycast = acceleratedRaycast;
      const [hit] = this.raycaster.intersectObject(mesh, false);
      if (!hit || hit.distance >= closest) continue;
      [nearest, closest] = [id, hit.distance];
    }
    return nearest;
  }

  dispose(): void {
    for (const set of [this.limited, this.smooth, this.before, this.after]) set.dispose();
    this.merged?.dispose();
    this.strokes.dispose();
    this.limitedPoses.dispose();
    this.smoothPoses.dispose();
    this.limitedPaint.ramp.value.dispose();
  }

  private geometryOf(mesh: TuftMesh): BufferGeometry {
    const known = this.geometries.get(mesh);
    if (known) return known;
    const made = tuftGeometry(mesh);
    this.geometries.set(mesh, made);
    return made;
  }

  private paintHighlights(): void {
    if (!this.merged) return;
    markTufts(this.merged, this.tufts, (i) => {
      const { id } = this.tufts[i]!;
      return this.selectedIds.includes(id) ? kSelected : id === this.hoveredId ? kHovered : 0;
    });
  }
}
