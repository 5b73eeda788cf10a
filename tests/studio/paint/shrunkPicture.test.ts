import { shrunkPicture } from "../../../client-examples/studio/src/paint/shrunkPicture";

describe("shrunkPicture", () => {
  it("turns rows over and keeps solid colors", () => {
    const bottomUp = new Uint8Array([10, 20, 30, 255, 40, 50, 60, 255]);
    expect([...shrunkPicture(bottomUp, 1, 2, 1)]).toEqual([40, 50, 60, 255, 10, 20, 30, 255]);
  });

  it("gives an edge the color of what is there, and its share as alpha", () => {
    const quarter = new Uint8Array([200, 100, 50, 255, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]);
    expect([...shrunkPicture(quarter, 1, 1, 2)]).toEqual([200, 100, 50, 64]);
  });

  it("undoes the multiplication by alpha", () => {
    expect([...shrunkPicture(new Uint8Array([50, 25, 0, 128]), 1, 1, 1)]).toEqual([100, 50, 0, 128]);
  });

  it("leaves what is empty empty", () => {
    expect([...shrunkPicture(new Uint8Array(4), 1, 1, 1)]).toEqual([0, 0, 0, 0]);
  });
});
