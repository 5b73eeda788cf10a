import { Group, type BufferGeometry, type Mesh } from "three";
import type { SharedUniforms } from "../paint/sharedUniforms";
import { tuftMaterials, type TuftMaterials } from "../paint/tuftMaterials";
import { tuftMesh } from "../paint/tuftMesh";

export interface PlacedTuft {
  readonly id: number;
  readonly geometry: BufferGeometry;
  /** Where its joints begin among all. */
  readonly firstJoint: number;
}

interface Shown {
  readonly geometry: BufferGeometry;
  readonly materials: TuftMaterials;
  readonly mesh: Mesh;
  id: number;
}

/** All tufts, painted in one way: the hair itself, or a ghost of it. Geometries belong to the caller. */
export class TuftSet {
  readonly group = new Group();
  private shown: Shown[] = [];

  constructor(private readonly shared: SharedUniforms, private readonly opacity = 1) {}

  set(tufts: readonly PlacedTuft[]): void {
    const old = new Map(this.shown.map((one) => [one.geometry, one]));
    this.shown = tufts.map(({ id, geometry, firstJoint }) => {
      const one = old.get(geometry) ?? this.make(geometry);
      old.delete(geometry);
      one.id = id;
      one.materials.firstJoint.value = firstJoint;
      return one;
    });
    for (const gone of old.values()) this.drop(gone);
  }

  /** @param strength  0..1 for a tuft's id */
  highlight(strength: (id: number) => number): void {
    for (const { id, materials } of this.shown) materials.highlight.value = strength(id);
  }

  get meshes(): readonly { readonly id: number; readonly mesh: Mesh }[] {
    return this.shown;
  }

  dispose(): void {
    for (const one of this.shown) this.drop(one);
    this.shown = [];
  }

  private make(geometry: BufferGeometry): Shown {
    const materials = tuftMaterials(this.shared);
    materials.opacity = this.opacity;
    const mesh = tuftMesh(geometry, materials);
    if (this.opacity < 1) mesh.castShadow = false;
    this.group.add(mesh);
    return { id: 0, geometry, materials, mesh };
  }

  private drop({ mesh, materials }: Shown): void {
    this.group.remove(mesh);
    materials.dispose();
  }
}
