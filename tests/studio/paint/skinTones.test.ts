import { hairTones } from "../../../client-examples/studio/src/paint/hairTones";
import { skinTones } from "../../../client-examples/studio/src/paint/skinTones";
import { toOklch } from "../../../client-examples/studio/src/paint/toOklch";

describe("skinTones", () => {
  it.each(["#fee9dc", "#e0b090", "#8d5a3c"])("shades %s warm", (color) => {
    const tones = skinTones(color).map(toOklch);
    expect(skinTones(color)[2]).toBe(color);
    for (const { hue } of tones.slice(0, 2)) expect(Math.abs(hue - 38)).toBeLessThan(8);
    expect(tones[0]!.lightness).toBeLessThan(tones[1]!.lightness);
    expect(tones[1]!.lightness).toBeLessThan(tones[2]!.lightness);
  });

  it.each(["#3060c0", "#20c060", "#202020"])("shades %s as hair, since it is not skin", (color) => {
    expect(skinTones(color)).toEqual(hairTones(color).tones);
  });
});
