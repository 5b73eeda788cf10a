import { PoseTexture } from "../../../client-examples/studio/src/paint/PoseTexture";

const image = (texture: PoseTexture): { data: Float32Array; width: number; height: number } =>
  texture.uniforms.poses.value.image as { data: Float32Array; width: number; height: number };

describe("PoseTexture", () => {
  it("is at rest before anything is set", () => {
    const { uniforms } = new PoseTexture();
    expect([uniforms.poseJoints.value, uniforms.posePictures.value, uniforms.picture.value]).toEqual([0, 0, -1]);
  });

  it("holds three texels for every joint of every picture, one after the other", () => {
    const texture = new PoseTexture();
    const matrices = Float32Array.from({ length: 2 * 3 * 12 }, (_, i) => i);
    texture.set(2, 3, matrices);
    expect([...image(texture).data.subarray(0, matrices.length)]).toEqual([...matrices]);
    expect([texture.uniforms.posePictures.value, texture.uniforms.poseJoints.value]).toEqual([2, 3]);
  });

  // The service's most joints, and a cycle of two seconds on twos at 24 fps.
  it("has room for 16,384 joints in 24 pictures, in a width that is a power of two", () => {
    const texture = new PoseTexture();
    const matrices = new Float32Array(24 * 16384 * 12);
    matrices[matrices.length - 1] = 7;
    texture.set(24, 16384, matrices);
    const { data, width, height } = image(texture);
    expect(Math.log2(width) % 1).toBe(0);
    expect(Math.max(width, height)).toBeLessThanOrEqual(2048);
    expect(data[matrices.length - 1]).toBe(7);
  });

  it("keeps its texture, and the uniform's object, while there is room", () => {
    const texture = new PoseTexture();
    const { poses } = texture.uniforms;
    texture.set(4, 100, new Float32Array(4 * 100 * 12));
    const before = poses.value;
    texture.set(2, 50, new Float32Array(2 * 50 * 12));
    expect(poses.value).toBe(before);
  });

  it("refuses fewer numbers than matrices need, and more than a texture holds", () => {
    expect(() => new PoseTexture().set(2, 3, new Float32Array(71))).toThrow(RangeError);
    const endless = { length: Infinity } as Float32Array;
    expect(() => new PoseTexture().set(100, 100000, endless)).toThrow(RangeError);
  });
});
