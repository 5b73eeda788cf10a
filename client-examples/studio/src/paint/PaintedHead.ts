import type * as THREE from "three";
import type { components } from "../api/generated/openapi";

/** A head under the hair, ready for a Stage. */
export interface PaintedHead {
  /** What is drawn. */
  readonly group: THREE.Group;
  /** Everything that a ray can hit, in the world's frame. It is not in the group. */
  readonly surface: THREE.Mesh<THREE.BufferGeometry>;
  /** Where hair grows, as the service takes it. */
  readonly scalp: components["schemas"]["ScalpMesh"];
  /**
   * Paints the scalp like the hair, so that no skin shines through.
   * @param tones  three CSS colors, darkest first
   * @param brow  the eyebrows' color; if left out, the darkest tone
   */
  setScalpTones(tones: readonly [string, string, string], brow?: string): void;
  dispose(): void;
}
