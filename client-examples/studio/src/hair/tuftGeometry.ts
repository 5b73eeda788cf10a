import { BufferAttribute, BufferGeometry } from "three";
import { addSmoothedNormals } from "../paint/addSmoothedNormals";
import type { TuftMesh } from "./TuftMesh";

/** A tuft's mesh for the graphics card, as tuftMaterials wants it. The caller disposes of it. */
export function tuftGeometry({ positions, normals, joints, weights, indices }: TuftMesh): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setAttribute("joints", new BufferAttribute(joints, 4));
  geometry.setAttribute("weights", new BufferAttribute(weights, 4));
  geometry.setIndex(new BufferAttribute(indices, 1));
  addSmoothedNormals(geometry);
  return geometry;
}
