// The scalp of the head in tests/data as a request has it.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const kHead = fileURLToPath(new URL("../data/heads/mpfb_head_base.glb", import.meta.url));

function readScalp() {
  const file = readFileSync(kHead);
  const jsonLength = file.readUInt32LE(12);
  const gltf = JSON.parse(file.subarray(20, 20 + jsonLength));
  const data = file.subarray(28 + jsonLength);
  const primitive = gltf.meshes[0].primitives.find(({ material }) => gltf.materials[material].name === "scalp");
  const bytesOf = (index) => data.subarray(gltf.bufferViews[gltf.accessors[index].bufferView].byteOffset);
  const corners = bytesOf(primitive.indices);
  const points = bytesOf(primitive.attributes.POSITION);
  const indices = Array.from({ length: gltf.accessors[primitive.indices].count }, (_, i) => corners.readUInt16LE(2 * i));
  const point = (i) => [0, 1, 2].map((axis) => points.readFloatLE(12 * i + 4 * axis));
  return { indices, point };
}

/** @param place  position and scale, from the file's frame to the hair's
 *  @return  a head's `scalp`, with the vertices that its triangles use */
export function scalpAt({ position, scale }) {
  const { indices, point } = readScalp();
  const numbers = new Map();
  for (const index of indices) if (!numbers.has(index)) numbers.set(index, numbers.size);
  const placed = (index) => point(index).map((x, axis) => +(x * scale[axis] + position[axis]).toFixed(6));
  return { mesh: { positions: [...numbers.keys()].flatMap(placed), triangles: indices.map((index) => numbers.get(index)) } };
}
