import { BufferAttribute, BufferGeometry } from "three";

/** A tuft among others: its geometry and how many joints it has. */
export interface TuftPart {
  readonly geometry: BufferGeometry;
  readonly joints: number;
}

const kNumbers = { position: 3, normal: 3, smoothed: 3, weights: 4 } as const;

/**
 * All tufts as one geometry, so that a head of hair is drawn in three calls and not in three for each tuft. Joints are counted through
 * all of them; `mark` tells of each vertex how much of the accent is mixed in. The caller disposes of it.
 * @param parts  of tuftGeometry
 */
export function mergedTufts(parts: readonly TuftPart[]): BufferGeometry {
  const vertices = parts.reduce((sum, { geometry }) => sum + geometry.getAttribute("position").count, 0);
  const corners = parts.reduce((sum, { geometry }) => sum + geometry.getIndex()!.count, 0);
  const merged = new BufferGeometry();
  for (const [name, size] of Object.entries(kNumbers)) {
    const numbers = new Float32Array(size * vertices);
    let at = 0;
    for (const { geometry } of parts) {
      const { array } = geometry.getAttribute(name);
      numbers.set(array, at);
      at += array.length;
    }
    merged.setAttribute(name, new BufferAttribute(numbers, size));
  }
  const joints = new Uint16Array(4 * vertices);
  const indices = new Uint32Array(corners);
  let [vertex, joint, corner] = [0, 0, 0];
  for (const part of parts) {
    const own = part.geometry.getAttribute("joints").array;
    for (let i = 0; i < own.length; i++) joints[4 * vertex + i] = own[i]! + joint;
    const index = part.geometry.getIndex()!.array;
    for (let i = 0; i < index.length; i++) indices[corner + i] = index[i]! + vertex;
    vertex += own.length / 4;
    joint += part.joints;
    corner += index.length;
  }
  merged.setAttribute("joints", new BufferAttribute(joints, 4));
  merged.setAttribute("mark", new BufferAttribute(new Float32Array(vertices), 1));
  merged.setIndex(new BufferAttribute(indices, 1));
  return merged;
}
