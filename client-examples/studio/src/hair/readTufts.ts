import type { TuftMesh } from "./TuftMesh";

interface Accessor { readonly bufferView: number; readonly byteOffset?: number; readonly componentType: number; readonly count: number; readonly type: string }
interface Gltf {
  readonly accessors: readonly Accessor[];
  readonly bufferViews: readonly { readonly byteOffset?: number; readonly byteLength: number }[];
  readonly meshes: readonly { readonly primitives: readonly { readonly attributes: Readonly<Record<string, number>>; readonly indices: number }[] }[];
  readonly nodes: readonly { readonly mesh?: number; readonly skin?: number }[];
  readonly skins: readonly { readonly inverseBindMatrices: number }[];
}

const kComponents: Readonly<Record<string, number>> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const kArrays = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array } as const;
const kJsonChunk = 20; // bytes before it: header 12, chunk header 8

/** Where joints stand at rest, from inverse bind matrices (columns of four): R^T p = -t, so p = -R t. */
function restOf(inverseBinds: Float32Array): Float32Array {
  const rest = new Float32Array((inverseBinds.length / 16) * 3);
  for (let joint = 0; joint * 16 < inverseBinds.length; joint++) {
    const m = inverseBinds.subarray(16 * joint, 16 * joint + 16);
    for (let axis = 0; axis < 3; axis++) {
      rest[3 * joint + axis] = -(m[4 * axis]! * m[12]! + m[4 * axis + 1]! * m[13]! + m[4 * axis + 2]! * m[14]!);
    }
  }
  return rest;
}

/**
 * The tufts of a GLB of /v1/tufts, in the order that was asked for. Only what the service writes is read: tight accessors, one
 * primitive a tuft.
 */
export function readTufts(glb: ArrayBuffer): TuftMesh[] {
  const jsonLength = new DataView(glb).getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(glb, kJsonChunk, jsonLength))) as Gltf;
  const binary = kJsonChunk + jsonLength + 8;
  const arrayOf = (index: number): Float32Array | Uint16Array | Uint32Array => {
    const accessor = gltf.accessors[index]!;
    const View = kArrays[accessor.componentType as keyof typeof kArrays];
    const start = binary + (gltf.bufferViews[accessor.bufferView]!.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
    return new View(glb, start, accessor.count * kComponents[accessor.type]!);
  };
  return gltf.nodes.flatMap(({ mesh, skin }) => {
    if (mesh === undefined || skin === undefined) return [];
    const { attributes, indices } = gltf.meshes[mesh]!.primitives[0]!;
    return [{
      positions: arrayOf(attributes.POSITION!) as Float32Array,
      normals: arrayOf(attributes.NORMAL!) as Float32Array,
      joints: arrayOf(attributes.JOINTS_0!) as Uint16Array,
      weights: arrayOf(attributes.WEIGHTS_0!) as Float32Array,
      indices: arrayOf(indices) as Uint16Array | Uint32Array,
      rest: restOf(arrayOf(gltf.skins[skin]!.inverseBindMatrices) as Float32Array),
    }];
  });
}
