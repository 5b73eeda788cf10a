import type { BufferGeometry } from "three";
import { markTufts } from "../hair/markTufts";
import { mergedTufts } from "../hair/mergedTufts";
import { tuftGeometry } from "../hair/tuftGeometry";
import type { TuftMesh } from "../hair/TuftMesh";
import { TuftSet } from "../hair/TuftSet";
import type { HeadBall } from "../model/HeadBall";
import { hairTones } from "../paint/hairTones";
import { PoseTexture } from "../paint/PoseTexture";
import { setHairTones } from "../paint/setHairTones";
import { sharedUniforms } from "../paint/sharedUniforms";

const kOpacity = 0.6;
const kTint = 0.35; // of the accent, since it is not hair yet

/** Tufts that may come: the preview of a fill. */
export class GhostView {
  private readonly poses = new PoseTexture();
  private readonly paint;
  private readonly tufts: TuftSet;
  private merged: BufferGeometry | null = null;

  constructor(color: string) {
    this.paint = sharedUniforms(this.poses, hairTones(color));
    this.tufts = new TuftSet(this.paint, kOpacity);
  }

  get group() {
    return this.tufts.group;
  }

  show(meshes: readonly TuftMesh[]): void {
    this.merged?.dispose();
    const parts = meshes.map((mesh) => ({ geometry: tuftGeometry(mesh), joints: mesh.rest.length / 3 }));
    this.merged = parts.length > 0 ? mergedTufts(parts) : null;
    if (this.merged) markTufts(this.merged, parts, () => kTint);
    this.tufts.show(this.merged);
  }

  /** The head that they are on. */
  setHead({ center }: HeadBall): void {
    this.paint.center.value.set(...center);
  }

  setColor(color: string): void {
    setHairTones(this.paint, hairTones(color));
  }

  dispose(): void {
    this.show([]);
    this.tufts.dispose();
    this.poses.dispose();
    this.paint.ramp.value.dispose();
  }
}
