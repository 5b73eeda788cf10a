/** A tuft as the service meshes it, at rest. */
export interface TuftMesh {
  /** x, y, z of each vertex, metres. */
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  /** Four joints of each vertex, counted from the tuft's root, and how much each counts. */
  readonly joints: Uint16Array;
  readonly weights: Float32Array;
  readonly indices: Uint16Array | Uint32Array;
  /** x, y, z of each joint at rest, metres. */
  readonly rest: Float32Array;
}
