import type { Wave } from "../api/contract";
import { hairLine } from "./hairLine";
import { wavePoint } from "./wavePoint";

type Point = readonly [number, number];

/** Enough that the tip's path and the curve look round at the plot's size. */
const kPathPoints = 120;
const kCurvePoints = 96;

const at = (fraction: number) => fraction * Math.PI;

/** All lines of a wave that do not change while it plays, in units where the hair is pi long. */
export class WaveShape {
  /** The hair in each picture, root first. */
  readonly hairs: readonly (readonly Point[])[];
  /** Where the tip goes in one cycle, closed. */
  readonly tipPath: readonly Point[];
  /** Equation (1) in each picture. */
  readonly curves: readonly (readonly Point[])[];
  /** The lowest and highest y of the hair over the whole cycle. */
  readonly bottom: number;
  readonly top: number;
  /** The same of the tip alone. */
  readonly tipBottom: number;
  readonly tipTop: number;

  /** @param phases  one per picture, radians */
  constructor(wave: Required<Wave>, phases: readonly number[], segments: number) {
    const tips = Array.from({ length: kPathPoints + 1 }, (_, i) => hairLine(wave, at((2 * i) / kPathPoints), segments));
    this.tipPath = tips.map((line) => line[segments] ?? [0, 0]);
    this.hairs = phases.map((phase) => hairLine(wave, phase, segments));
    this.curves = phases.map((phase) =>
      Array.from({ length: kCurvePoints + 1 }, (_, i) => [at(i / kCurvePoints), wavePoint(wave, at(i / kCurvePoints), phase)] as const));
    const heights = tips.flatMap((line) => line.map(([, y]) => y));
    [this.bottom, this.top] = [Math.min(...heights), Math.max(...heights)];
    const tipHeights = this.tipPath.map(([, y]) => y);
    [this.tipBottom, this.tipTop] = [Math.min(...tipHeights), Math.max(...tipHeights)];
  }
}
