import { colorParts } from "./colorParts";

/** A color, its red, green and blue each times a factor; as on the screen, without a change of color space. @param color  #rrggbb */
export function scaleColor(color: string, factors: readonly [number, number, number]): string {
  const parts = colorParts(color).map((part, i) => Math.round(255 * Math.min(1, part * factors[i]!)));
  return `#${parts.map((part) => part.toString(16).padStart(2, "0")).join("")}`;
}
