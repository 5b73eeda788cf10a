import { kindOfFile } from "../../../client-examples/studio/src/bring/kindOfFile";

const textBytes = (text: string): ArrayBuffer => new TextEncoder().encode(text).buffer as ArrayBuffer;

/** A GLB of one JSON chunk, the least that is one. */
function glb(json: string): ArrayBuffer {
  const text = new TextEncoder().encode(json.padEnd(Math.ceil(json.length / 4) * 4));
  const bytes = new ArrayBuffer(20 + text.length);
  const view = new DataView(bytes);
  [0x46546c67, 2, bytes.byteLength, text.length, 0x4e4f534a].forEach((word, i) => view.setUint32(4 * i, word, true));
  new Uint8Array(bytes, 20).set(text);
  return bytes;
}

describe("kindOfFile", () => {
  it("takes JSON with tufts for a hairstyle", () => {
    expect(kindOfFile(textBytes('{"tufts": []}'))).toEqual({ kind: "hairstyle", hairstyle: { tufts: [] } });
  });

  it("takes JSON with a byte order mark", () => {
    expect(kindOfFile(textBytes('\ufeff{"tufts": []}')).kind).toBe("hairstyle");
  });

  it("finds the recipe in a file that Tuftwave made", () => {
    const made = glb('{"asset": {"version": "2.0", "extras": {"tuftwave": {"hairstyle": {"tufts": []}}}}}');
    expect(kindOfFile(made)).toEqual({ kind: "hairstyle", hairstyle: { tufts: [] } });
  });

  it.each([["without extras", '{"asset": {"version": "2.0"}}'], ["with extras of others", '{"asset": {"extras": {"tuftwave": 1}}}']])("takes a GLB %s for a model", (_, json) => {
    expect(kindOfFile(glb(json))).toEqual({ kind: "model" });
  });

  it.each([[3, "unknown"], [4, "cut"], [19, "cut"], [30, "cut"]])("tells a GLB of which %i bytes are left", (left, kind) => {
    expect(kindOfFile(glb('{"asset": {"version": "2.0"}}').slice(0, left)).kind).toBe(kind);
  });

  it.each(["", "hello", "[1, 2]", "null", '{"hello": 1}', '{"tufts": ['])("knows nothing of %j", (text) => {
    expect(kindOfFile(textBytes(text))).toEqual({ kind: "unknown" });
  });

  it("knows nothing of a GLB whose JSON is none, nor of a picture", () => {
    expect(kindOfFile(glb("{{{{")).kind).toBe("unknown");
    expect(kindOfFile(new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]).buffer).kind).toBe("unknown");
  });
});
