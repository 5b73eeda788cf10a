/** A wave as one would tell it. Lengths are shares of the hair's length. */
export interface WaveSummary {
  /** Whether it runs from root to tip. */
  readonly toTip: boolean;
  readonly wavelength: number;
  /** Between the tip's highest and lowest place. */
  readonly swing: number;
  /** How high the middle between those is above the straight line; droop is negative. */
  readonly rise: number;
  readonly pictures: number;
  /** The picture now shown, from 0. */
  readonly picture: number;
}
