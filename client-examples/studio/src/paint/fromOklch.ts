import type { Oklch } from "./toOklch";

const kSteps = 12; // of the search for the chroma: to 0.0001
const kSlack = 1e-4; // of 1: less than half a step of a byte

const encoded = (value: number): number => (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055);

function linearRgb({ lightness, chroma, hue }: Oklch): number[] {
  const [green, blue] = [chroma * Math.cos((hue * Math.PI) / 180), chroma * Math.sin((hue * Math.PI) / 180)];
  const l = (lightness + 0.3963377774 * green + 0.2158037573 * blue) ** 3;
  const m = (lightness - 0.1055613458 * green - 0.0638541728 * blue) ** 3;
  const s = (lightness - 0.0894841775 * green - 1.291485548 * blue) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}

const fits = (rgb: readonly number[]): boolean => rgb.every((value) => value > -kSlack && value < 1 + kSlack);

/**
 * The nearest color that a screen can show, as "#rrggbb": lightness and hue stay, chroma gives way.
 * @param color  lightness outside 0..1 is moved to the end of the range
 */
export function fromOklch(color: Oklch): string {
  const lightness = Math.min(1, Math.max(0, color.lightness));
  let chroma = Math.max(0, color.chroma);
  if (!fits(linearRgb({ ...color, lightness, chroma }))) {
    let [low, high] = [0, chroma];
    for (let i = 0; i < kSteps; i++) {
      const middle = (low + high) / 2;
      if (fits(linearRgb({ ...color, lightness, chroma: middle }))) low = middle;
      else high = middle;
    }
    chroma = low;
  }
  const bytes = linearRgb({ ...color, lightness, chroma }).map((value) => Math.round(255 * encoded(Math.min(1, Math.max(0, value)))));
  return `#${bytes.map((byte) => byte.toString(16).padStart(2, "0")).join("")}`;
}
