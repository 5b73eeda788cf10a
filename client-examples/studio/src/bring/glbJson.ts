const kMagic = 0x46546c67; // "glTF"
const kJsonChunk = 0x4e4f534a; // "JSON"
const kChunkStart = 20; // header 12, chunk header 8

/** What the first chunk of a GLB holds; "cut" is a GLB whose end is missing, null is none. */
export function glbJson(bytes: ArrayBuffer): unknown {
  const view = new DataView(bytes);
  if (view.byteLength < 4 || view.getUint32(0, true) !== kMagic) return null;
  if (view.byteLength < kChunkStart || view.byteLength < view.getUint32(8, true)) return "cut";
  const length = view.getUint32(12, true);
  if (view.getUint32(16, true) !== kJsonChunk || kChunkStart + length > view.byteLength) return "cut";
  try {
    return JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, kChunkStart, length))) as unknown;
  } catch {
    return null;
  }
}
