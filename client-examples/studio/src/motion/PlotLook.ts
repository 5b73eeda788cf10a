/** Colors, font and words of the wave's plot. */
export interface PlotLook {
  readonly accent: string;
  readonly ink: string;
  readonly soft: string;
  readonly paper: string;
  readonly font: string;
  readonly root: string;
  readonly tip: string;
}
