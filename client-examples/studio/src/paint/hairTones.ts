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

/** One tone from the picked color. */
interface Mixture {
  readonly lightness: number;
  /** Times the picked chroma. */
  readonly gain: number;
  /** Times the turn of the deep shade. */
  readonly turns: number;
  /** Chroma of violet that pure grey gets. */
  readonly violet: number;
}

// Degrees that the hue turns in the deep shade, by hue: on the shorter way to violet, yellow by orange, green by blue. Read off palettes
// that were mixed by hand (rose, teal, gold, violet, auburn); the rest lies between.
const kTurns = [
  ...([[0, -7], [45, -16], [87, -24], [106, -22]] as const),
  ...([[118, 14], [145, 22], [200, 28], [245, 16], [285, 0], [330, -5], [360, -7]] as const),
];
const kSteps = { middle: 0.12, dark: 0.245 }; // of lightness below the light tone
const kDim = 0.6; // lightness under which the steps get smaller
const kGrey = 0.085; // chroma under which shade borrows violet
const kViolet = { hue: 287, light: 0.006, middle: 0.026, dark: 0.036, line: 0.04 };
const kBlack = { least: 0.33, share: 0.3, hue: 268, light: 0.026 }; // black hair is lit by the sky: blue-grey
const kWhite = 0.958; // lightness; above it, the band of light would not be seen

const clamp = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

function turnOf(hue: number): number {
  const next = Math.max(1, kTurns.findIndex(([at]) => hue < at));
  const [[from, low], [to, high]] = [kTurns[next - 1]!, kTurns[next]!];
  return low + ((hue - from) / (to - from)) * (high - low);
}

/**
 * The palette of a color of hair, as a cel painter would mix it: shade turns to violet, light to warm, grey shade to lavender, and black
 * hair is lit blue-grey.
 * @param color  "#rgb" or "#rrggbb"; it is the light tone, unless it is almost black or white
 * @throws RangeError if it is neither
 */
export function hairTones(color: string): HairTones {
  const picked = toOklch(color);
  const lightness = Math.min(kWhite, Math.max(picked.lightness, kBlack.least + kBlack.share * picked.lightness));
  const black = lightness > picked.lightness;
  const grey = clamp(1 - picked.chroma / kGrey, 0, 1);
  const turn = turnOf(picked.hue);
  const mix = ({ lightness: tone, gain, turns, violet }: Mixture): string => {
    const own = radians(picked.hue + turns * turn);
    const lent = radians(black ? kBlack.hue : kViolet.hue);
    const [a, b] = [Math.cos, Math.sin].map((part) => gain * picked.chroma * part(own) + violet * grey * part(lent)) as [number, number];
    return fromOklch({ lightness: tone, chroma: Math.sqrt(a * a + b * b), hue: (Math.atan2(b, a) * 180) / Math.PI });
  };

  const scale = Math.min(1, lightness / kDim);
  const dark = lightness - kSteps.dark * scale;
  const light = black ? kBlack.light : kViolet.light;
  const shine = lightness + (0.985 - lightness) * clamp(0.42 + 1.05 * (lightness - 0.38), 0.42, 1);
  const line = clamp(0.29 + 0.62 * (lightness - 0.67), 0.13, Math.max(0.13, dark - 0.07));
  return {
    tones: [
      mix({ lightness: dark, gain: 1, turns: 1, violet: kViolet.dark }),
      mix({ lightness: lightness - kSteps.middle * scale, gain: 1.12, turns: 0.5, violet: kViolet.middle }),
      mix({ lightness, gain: 1, turns: 0, violet: light }),
    ],
    shine: mix({ lightness: shine, gain: clamp(1.1 - 0.85 * lightness, 0.38, 0.7), turns: -0.5, violet: light }),
    line: mix({ lightness: line, gain: 0.68, turns: 1.3, violet: kViolet.line }),
  };
}
