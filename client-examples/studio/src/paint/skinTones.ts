import { fromOklch } from "./fromOklch";
import { hairTones } from "./hairTones";
import { toOklch } from "./toOklch";

// As kSkin's are to each other. Skin is shaded warm; violet would make it look ill.
const kShade = [{ lightness: -0.125, chroma: 0.04, hue: 36 }, { lightness: -0.065, chroma: 0.02, hue: 40 }] as const;
const kSkin = { hue: [15, 85], chroma: [0.012, 0.12], lightness: 0.4 } as const;

/**
 * Three tones for a color that is on a head: like skin if it is one, like hair if not.
 * @param color  "#rrggbb", the light tone
 * @return  darkest first
 */
export function skinTones(color: string): readonly [string, string, string] {
  const { lightness, chroma, hue } = toOklch(color);
  const isSkin = hue > kSkin.hue[0] && hue < kSkin.hue[1] && chroma > kSkin.chroma[0] && chroma < kSkin.chroma[1] && lightness > kSkin.lightness;
  if (!isSkin) return hairTones(color).tones;
  const shade = (by: (typeof kShade)[number]): string => fromOklch({ lightness: lightness + by.lightness, chroma: chroma + by.chroma, hue: by.hue });
  return [shade(kShade[0]), shade(kShade[1]), color];
}
