/** Lightness 0..1, chroma 0..0.4, hue in degrees 0..360. */
export interface Oklch {
  readonly lightness: number;
  readonly chroma: number;
  readonly hue: number;
}

const linear = (value: number): number => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);

/**
 * A CSS hex color in the Oklab space as lightness, chroma and hue, where equal steps look equal.
 * Source: B. Ottosson, "A perceptual color space for image processing", 2020.
 * @param color  "#rgb" or "#rrggbb"
 * @throws RangeError if it is neither
 */
export function toOklch(color: string): Oklch {
  const digits = /^#(?:([0-9a-f]{3})|([0-9a-f]{6}))$/i.exec(color.trim());
  if (!digits) throw new RangeError(`not a hex color: ${color}`);
  const pairs = digits[2] ?? [...(digits[1] ?? "")].map((digit) => digit + digit).join("");
  const [r, g, b] = [0, 2, 4].map((at) => linear(parseInt(pairs.slice(at, at + 2), 16) / 255)) as [number, number, number];
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  const green = 1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s;
  const blue = 0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s;
  return {
    lightness: 0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    chroma: Math.sqrt(green * green + blue * blue),
    hue: ((Math.atan2(blue, green) * 180) / Math.PI + 360) % 360,
  };
}
