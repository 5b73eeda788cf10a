import { CatmullRomCurve3, Vector3 } from "three";
import type { Vec3 } from "../api/contract";

const kPerSegment = 12;

/** Points along the curve through a stroke's points, as the service draws it (centripetal Catmull-Rom). */
export function strokeLine(points: readonly Vec3[]): Vector3[] {
  const places = points.map((point) => new Vector3(...point)).filter((place, i, all) => i === 0 || place.distanceTo(all[i - 1]!) > 1e-9);
  if (places.length < 2) return places;
  return new CatmullRomCurve3(places, false, "centripetal").getPoints(kPerSegment * (places.length - 1));
}
