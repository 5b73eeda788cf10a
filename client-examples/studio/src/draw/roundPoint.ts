import type { Vector3 } from "three";
import type { Vec3 } from "../api/contract";

const kMicrometers = 1e6; // finer than any hand, and files stay readable

/** A place of the scene as a point of a stroke. */
export function roundPoint({ x, y, z }: Vector3): Vec3 {
  const round = (value: number) => Math.round(value * kMicrometers) / kMicrometers + 0;
  return [round(x), round(y), round(z)];
}
