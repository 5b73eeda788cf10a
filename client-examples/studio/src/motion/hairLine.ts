import type { Wave } from "../api/contract";
import { wavePoint } from "./wavePoint";

/**
 * The hair as the service poses it in absolute mode: bones of one length, turned by the angles of equation (1)'s chords.
 * @param phase  2 pi t / T, radians
 * @param segments  bones, at least 1
 * @returns segments + 1 points, root first at the origin, in units where the hair is pi long
 */
export function hairLine(wave: Required<Wave>, phase: number, segments: number): [number, number][] {
  const bone = Math.PI / segments;
  const line: [number, number][] = [[0, 0]];
  let [x, y, height] = [0, 0, 0];
  for (let i = 1; i <= segments; ++i) {
    const next = wavePoint(wave, i * bone, phase);
    const angle = Math.atan2(next - height, bone);
    x += bone * Math.cos(angle);
    y += bone * Math.sin(angle);
    height = next;
    line.push([x, y]);
  }
  return line;
}
