// A GLB's JSON and buffer, read by ourselves and not by a library under test.
import { readFileSync } from "node:fs";

const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const ARRAYS = { 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };

/** @returns {{ json: any, bytes: ArrayBuffer, data: (accessor: number) => Float32Array | Uint16Array | Uint32Array, width: (accessor: number) => number }} */
export function readGlb(path) {
  const file = readFileSync(path);
  const bytes = file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength);
  const header = new DataView(bytes);
  if (header.getUint32(0, true) !== 0x46546c67 || header.getUint32(8, true) !== bytes.byteLength) throw new Error("is no GLB of its own length");
  const chunks = new Map();
  for (let at = 12; at < bytes.byteLength; at += 8 + header.getUint32(at, true)) {
    chunks.set(header.getUint32(at + 4, true), bytes.slice(at + 8, at + 8 + header.getUint32(at, true)));
  }
  const json = JSON.parse(new TextDecoder().decode(chunks.get(0x4e4f534a)));
  const buffer = chunks.get(0x004e4942);
  const width = (accessor) => WIDTHS[json.accessors[accessor].type];
  const data = (accessor) => {
    const { bufferView, byteOffset = 0, count, componentType } = json.accessors[accessor];
    const start = (json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset;
    return new ARRAYS[componentType](buffer, start, count * width(accessor));
  };
  return { json, bytes, data, width };
}
