import { hairTones } from "../../../client-examples/studio/src/paint/hairTones";
import { toOklch } from "../../../client-examples/studio/src/paint/toOklch";

// Around the wheel, and where painters mix otherwise: black, brown, grey, blond, white.
const kColors = ["#000000", "#1a1a22", "#4a2f20", "#808088", "#f3e3b0", "#ffffff", "#ff2a2a", "#ff8c1a", "#f0e030", "#38b048", "#5cc6cd", "#2040d0", "#8040e0", "#f58aac"];
const lightness = (color: string): number => toOklch(color).lightness;
const apart = (a: number, b: number): number => Math.abs(((a - b + 540) % 360) - 180);

describe("hairTones", () => {
  it.each(kColors)("%s goes from line over shade and light to shine, by steps that the eye sees", (color) => {
    const { tones, shine, line } = hairTones(color);
    const order = [line, ...tones, shine].map(lightness);
    for (let i = 1; i < order.length; i++) expect(order[i]! - order[i - 1]!).toBeGreaterThan(i === 4 ? 0.015 : 0.035);
  });

  it.each(kColors)("%s gives hex colors", (color) => {
    const { tones, shine, line } = hairTones(color);
    for (const tone of [...tones, shine, line]) expect(tone).toMatch(/^#[0-9a-f]{6}$/);
  });

  it.each(["#f58aac", "#5cc6cd", "#f9d57f", "#8f8ddb", "#d17a52", "#30a0ff"])("%s stays the light tone", (color) => {
    expect(hairTones(color).tones[2]).toBe(color);
  });

  // Mixed by hand, for the README's pictures: deep shade, shade, light.
  it.each([
    ["#a8406f", "#d9608e", "#f58aac"],
    ["#1f6c8c", "#3199b0", "#5cc6cd"],
    ["#c4823e", "#e6ae55", "#f9d57f"],
    ["#45408f", "#6560b8", "#8f8ddb"],
    ["#7e3328", "#ac4f38", "#d17a52"],
  ])("%s, %s, %s: shade is near the one mixed by hand", (dark, middle, light) => {
    for (const [i, byHand] of [dark, middle].entries()) {
      const [mixed, hand] = [toOklch(hairTones(light).tones[i]!), toOklch(byHand)];
      expect(Math.abs(mixed.lightness - hand.lightness)).toBeLessThan(0.045);
      expect(Math.abs(mixed.chroma - hand.chroma)).toBeLessThan(0.035);
      expect(apart(mixed.hue, hand.hue)).toBeLessThan(9);
    }
  });

  it("lights black hair blue-grey", () => {
    const { lightness: light, chroma, hue } = toOklch(hairTones("#000").tones[2]);
    expect(light).toBeGreaterThan(0.3);
    expect(chroma).toBeGreaterThan(0.015);
    expect(apart(hue, 268)).toBeLessThan(6);
  });

  it("shades white hair lavender", () => {
    expect(apart(toOklch(hairTones("#ffffff").tones[1]).hue, 287)).toBeLessThan(8);
  });

  it("turns grey when its color does, without a jump", () => {
    const [grey, almost] = [toOklch(hairTones("#a0a0a0").tones[0]), toOklch(hairTones("#a09f9f").tones[0])];
    expect(Math.abs(grey.lightness - almost.lightness) + Math.abs(grey.chroma - almost.chroma)).toBeLessThan(0.01);
  });

  it.each(["", "red", "#12345", "#gggggg"])("refuses %j", (color) => {
    expect(() => hairTones(color)).toThrow(RangeError);
  });
});
