import type { Picture } from "../api/contract";
import { poseMatrices } from "./poseMatrices";
import type { TuftMesh } from "./TuftMesh";

/** Every joint in every picture, as a PoseTexture takes it. */
export interface Poses {
  readonly pictures: number;
  readonly joints: number;
  readonly matrices: Float32Array;
}

/** The poses of tufts in the pictures of a cycle. @param pictures  of the service, a chain per tuft */
export function posesOf(pictures: readonly Picture[], meshes: readonly TuftMesh[]): Poses {
  const rests = meshes.map(({ rest }) => rest);
  const joints = rests.reduce((sum, rest) => sum + rest.length / 3, 0);
  return { pictures: pictures.length, joints, matrices: poseMatrices(pictures, rests) };
}
