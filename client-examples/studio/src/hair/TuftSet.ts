import { Group, Mesh, type BufferGeometry } from "three";
import type { SharedUniforms } from "../paint/sharedUniforms";
import { tuftMaterials } from "../paint/tuftMaterials";
import { tuftMesh } from "../paint/tuftMesh";

/** A head of hair, painted in one way: the hair itself, or a ghost of it. Geometries belong to the caller. */
export class TuftSet {
  readonly group = new Group();
  private readonly materials;
  /** Kept while it shows nothing: were its materials dropped, their programs would be compiled anew. */
  private mesh: Mesh | null = null;

  constructor(shared: SharedUniforms, private readonly opacity = 1) {
    this.materials = tuftMaterials(shared);
    this.materials.opacity = opacity;
  }

  /** @param geometry  of mergedTufts; null is none */
  show(geometry: BufferGeometry | null): void {
    if (geometry && !this.mesh) this.group.add((this.mesh = this.make(geometry)));
    else if (geometry) this.mesh?.traverse((part) => part instanceof Mesh && (part.geometry = geometry));
    if (this.mesh) this.mesh.visible = geometry !== null;
  }

  dispose(): void {
    this.materials.dispose();
  }

  private make(geometry: BufferGeometry): Mesh {
    const mesh = tuftMesh(geometry, this.materials);
    mesh.castShadow = this.opacity === 1;
    return mesh;
  }
}
