/**
 * A picture from one with several samples for each pixel: their mean.
 * @param pixels  RGBA, bottom row first, colors multiplied by alpha; (samples·width) × (samples·height)
 * @return  RGBA, top row first, colors not multiplied, as ImageData has them; width × height
 */
export function shrunkPicture(pixels: Uint8Array, width: number, height: number, samples: number): Uint8ClampedArray<ArrayBuffer> {
  const result = new Uint8ClampedArray(4 * width * height);
  const stride = 4 * samples * width;
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      let [r, g, b, a] = [0, 0, 0, 0];
      for (let row = 0; row < samples; row++) {
        let at = ((height - 1 - y) * samples + row) * stride + 4 * samples * x;
        for (let column = 0; column < samples; column++, at += 4) {
          r += pixels[at]!;
          g += pixels[at + 1]!;
          b += pixels[at + 2]!;
          a += pixels[at + 3]!;
        }
      }
      if (a === 0) continue;
      const to = 4 * (y * width + x);
      result[to] = (255 * r) / a;
      result[to + 1] = (255 * g) / a;
      result[to + 2] = (255 * b) / a;
      result[to + 3] = a / (samples * samples);
    }
  }
  return result;
}
