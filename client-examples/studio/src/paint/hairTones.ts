import { fromOklch } from "./fromOklch";
import { toOklch } from "./toOklch";

/** What one color of hair is painted with, as "#rrggbb". */
export interface HairTones {
  /** Deep shade, shade, light. */
  readonly tones: readonly [string, string, string];
  /** The band of light. */
  readonly shine: string;
  /** The outline. */
  readonly line: string;
}

const kShade = 287; // degrees: the violet that shade leans to
const kLeaning = { middle: 10, dark: 20, line: 26, shine: -12 }; // degrees, at most
const kSteps = { middle: 0.122, dark: 0.245 }; // of lightness below the light tone
const kDim = 0.6; // lightness under which the steps get smaller
const kGrey = 0.085; // chroma under which shade borrows the violet's
const kBorrowed = { light: 0.006, middle: 0.026, dark: 0.042, line: 0.04 }; // chroma that pure grey gets
const kBlack = { below: 0.46, lift: 0.3, hue: 268, chroma: 0.024 }; // black hair is lit by the sky: blue-grey
const kWhite = 0.958; // lightness; above it, the band of light would not be seen

const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));

/** Degrees by which a hue turns towards the shade's: none at it and none opposite it, where both ways are as long. */
function turn(hue: number, most: number): number {
  const sine = Math.sin(((kShade - hue) * Math.PI) / 180);
  return most * Math.sign(sine) * Math.sqrt(Math.abs(sine));
}

/**
 * The palette of a color of hair, as a cel painter would mix it: shade turns to violet, light to warm, grey shade to lavender, and black
 * hair is lit blue-grey.
 * @param color  "#rgb" or "#rrggbb", near the light tone
 * @throws RangeError if it is neither
 */
export function hairTones(color: string): HairTones {
  const picked = toOklch(color);
  const black = clamp(1 - picked.lightness / kBlack.below, 0, 1);
  const lightness = Math.min(kWhite, picked.lightness + kBlack.lift * black * (1.25 - 0.55 * black));
  const grey = clamp(1 - picked.chroma / kGrey, 0, 1);
  const hue = picked.hue;
  const scale = Math.min(1, lightness / kDim);

  /** The picked hue, turned, with chroma times `gain`, and as much of the violet as it is grey. */
  const mixed = (tone: number, gain: number, leaning: number, borrowed: number): string => {
    const own = ((hue + turn(hue, leaning)) * Math.PI) / 180;
    const violet = ((black > 0 ? kBlack.hue : kShade) * Math.PI) / 180;
    const chroma = gain * picked.chroma;
    const lent = borrowed * grey;
    const [a, b] = [chroma * Math.cos(own) + lent * Math.cos(violet), chroma * Math.sin(own) + lent * Math.sin(violet)];
    return fromOklch({ lightness: tone, chroma: Math.sqrt(a * a + b * b), hue: (Math.atan2(b, a) * 180) / Math.PI });
  };

  const dark = lightness - kSteps.dark * scale;
  const line = clamp(0.29 + 0.62 * (lightness - 0.67), 0.13, Math.max(0.13, dark - 0.07));
  const shine = lightness + (0.985 - lightness) * clamp(0.42 + 1.05 * (lightness - 0.38), 0.42, 1);
  const lifted = black > 0 ? kBlack.chroma * Math.min(1, 2 * black) : kBorrowed.light;
  return {
    tones: [
      mixed(dark, 0.96, kLeaning.dark, kBorrowed.dark * (0.5 + 0.5 * scale)),
      mixed(lightness - kSteps.middle * scale, 1.06, kLeaning.middle, kBorrowed.middle),
      lightness === picked.lightness && grey === 0 ? fromOklch(picked) : mixed(lightness, 1, 0, lifted),
    ],
    shine: mixed(shine, 0.42, kLeaning.shine, lifted),
    line: mixed(line, 0.68, kLeaning.line, kBorrowed.line),
  };
}
