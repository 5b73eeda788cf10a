import { Group, Mesh, type BufferGeometry } from "three";
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
  geometry: BufferGeometry;
  readonly materials: TuftMaterials;
  readonly mesh: Mesh;
  id: number;
}

/** All tufts, painted in one way: the hair itself, or a ghost of it. Geometries belong to the caller. */
export class TuftSet {
  readonly group = new Group();
  private shown: Shown[] = [];

  constructor(private readonly shared: SharedUniforms, private readonly opacity = 1) {}

  /** What is shown of another geometry is used again: were the last one dropped, its programs would be compiled anew for the next. */
  set(tufts: readonly PlacedTuft[]): void {
    const old = new Map(this.shown.map((one) => [one.geometry, one]));
    const kept = tufts.map(({ geometry }) => {
      const one = old.get(geometry);
      old.delete(geometry);
      return one;
    });
    const spare = [...old.values()];
    this.shown = tufts.map(({ id, geometry, firstJoint }, i) => {
      const one = kept[i] ?? reuse(spare.pop(), geometry) ?? this.make(geometry);
      one.id = id;
      one.materials.firstJoint.value = firstJoint;
      return one;
    });
    for (const gone of spare) this.drop(gone);
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

function reuse(one: Shown | undefined, geometry: BufferGeometry): Shown | null {
  if (!one) return null;
  one.geometry = geometry;
  one.materials.highlight.value = 0;
  one.mesh.traverse((part) => part instanceof Mesh && (part.geometry = geometry));
  return one;
}
