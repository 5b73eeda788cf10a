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
  const within = (value: number, [low, high]: readonly [number, number]): boolean => value > low && value < high;
  const isSkin = within(hue, kSkin.hue) && within(chroma, kSkin.chroma) && lightness > kSkin.lightness;
  if (!isSkin) return hairTones(color).tones;
  const [dark, middle] = kShade.map((by) => fromOklch({ lightness: lightness + by.lightness, chroma: chroma + by.chroma, hue: by.hue }));
  return [dark!, middle!, color];
}
