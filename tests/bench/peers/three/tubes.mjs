// W1's tubes: as three.js has them, with the radius laid over afterwards; and by hand into typed arrays.
import { BufferAttribute, BufferGeometry, CatmullRomCurve3, TubeGeometry, Vector3 } from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";

const RINGS = 64;
const SIDES = 12;
const COLUMNS = SIDES + 1;
const VERTICES = RINGS * COLUMNS;
const INDICES = (RINGS - 1) * SIDES * 6;
const WIDEST = 0.02; // radius, metres
const radiusAt = (ring) => WIDEST * Math.sin((Math.PI * ring) / (RINGS - 1));

/** A tube of radius 1, moved in to the radius of its ring. */
function stockTube(stroke) {
  const curve = new CatmullRomCurve3(stroke.map((point) => new Vector3(...point)));
  const tube = new TubeGeometry(curve, RINGS - 1, 1, SIDES);
  const { position, normal } = tube.attributes;
  for (let i = 0; i < position.count; i++) {
    const inward = radiusAt(Math.floor(i / COLUMNS)) - 1;
    position.setXYZ(i, position.getX(i) + inward * normal.getX(i), position.getY(i) + inward * normal.getY(i), position.getZ(i) + inward * normal.getZ(i));
  }
  return tube;
}

export const stockMerged = (strokes) => mergeGeometries(strokes.map(stockTube));

const COSINES = Float64Array.from({ length: COLUMNS }, (_, j) => Math.cos((2 * Math.PI * j) / SIDES));
const SINES = Float64Array.from({ length: COLUMNS }, (_, j) => Math.sin((2 * Math.PI * j) / SIDES));
const RADII = Float64Array.from({ length: RINGS }, (_, i) => radiusAt(i));
const centers = new Float64Array(3 * RINGS);

/** Catmull-Rom through the points, all rings of it. */
function placeCenters(stroke) {
  const pieces = stroke.length - 1;
  for (let i = 0; i < RINGS; i++) {
    const t = (i / (RINGS - 1)) * pieces;
    const piece = Math.min(Math.floor(t), pieces - 1);
    const u = t - piece;
    const a = stroke[Math.max(piece - 1, 0)];
    const b = stroke[piece];
    const c = stroke[piece + 1];
    const d = stroke[Math.min(piece + 2, pieces)];
    for (let axis = 0; axis < 3; axis++) {
      const [p, q, r, s] = [a[axis], b[axis], c[axis], d[axis]];
      centers[3 * i + axis] = 0.5 * (2 * q + (r - p) * u + (2 * p - 5 * q + 4 * r - s) * u * u + (3 * q - p - 3 * r + s) * u * u * u);
    }
  }
}

/** Writes a tube's vertices. @param first  of them, in the whole arrays */
function writeVertices(stroke, { positions, normals, uvs }, first) {
  placeCenters(stroke);
  let [nx, ny, nz] = [0, 0, 1];
  let at = 3 * first;
  let uv = 2 * first;
  for (let i = 0; i < RINGS; i++) {
    const before = 3 * Math.max(i - 1, 0);
    const after = 3 * Math.min(i + 1, RINGS - 1);
    let tx = centers[after] - centers[before];
    let ty = centers[after + 1] - centers[before + 1];
    let tz = centers[after + 2] - centers[before + 2];
    const length = Math.sqrt(tx * tx + ty * ty + tz * tz);
    [tx, ty, tz] = [tx / length, ty / length, tz / length];
    const along = nx * tx + ny * ty + nz * tz;
    [nx, ny, nz] = [nx - along * tx, ny - along * ty, nz - along * tz];
    const size = Math.sqrt(nx * nx + ny * ny + nz * nz);
    [nx, ny, nz] = [nx / size, ny / size, nz / size];
    const bx = ty * nz - tz * ny;
    const by = tz * nx - tx * nz;
    const bz = tx * ny - ty * nx;
    for (let j = 0; j < COLUMNS; j++) {
      const ox = COSINES[j] * nx + SINES[j] * bx;
      const oy = COSINES[j] * ny + SINES[j] * by;
      const oz = COSINES[j] * nz + SINES[j] * bz;
      positions[at] = centers[3 * i] + RADII[i] * ox;
      positions[at + 1] = centers[3 * i + 1] + RADII[i] * oy;
      positions[at + 2] = centers[3 * i + 2] + RADII[i] * oz;
      normals[at] = ox;
      normals[at + 1] = oy;
      normals[at + 2] = oz;
      uvs[uv] = j / SIDES;
      uvs[uv + 1] = i / (RINGS - 1);
      at += 3;
      uv += 2;
    }
  }
}

function writeIndices(indices, start, first) {
  let at = start;
  for (let i = 0; i + 1 < RINGS; i++) {
    for (let j = 0; j < SIDES; j++) {
      const a = first + i * COLUMNS + j;
      const b = a + COLUMNS;
      indices[at] = a;
      indices[at + 1] = b;
      indices[at + 2] = a + 1;
      indices[at + 3] = a + 1;
      indices[at + 4] = b;
      indices[at + 5] = b + 1;
      at += 6;
    }
  }
}

function arraysFor(tubes) {
  return { positions: new Float32Array(3 * VERTICES * tubes), normals: new Float32Array(3 * VERTICES * tubes), uvs: new Float32Array(2 * VERTICES * tubes) };
}

/** @param indices  BufferAttribute */
function geometryOf({ positions, normals, uvs }, indices) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setAttribute("uv", new BufferAttribute(uvs, 2));
  return geometry.setIndex(indices);
}

/** All tubes in one geometry, each array written once. */
export function leanMerged(strokes) {
  const arrays = arraysFor(strokes.length);
  const indices = new Uint32Array(INDICES * strokes.length);
  strokes.forEach((stroke, i) => {
    writeVertices(stroke, arrays, VERTICES * i);
    writeIndices(indices, INDICES * i, VERTICES * i);
  });
  return geometryOf(arrays, new BufferAttribute(indices, 1));
}

/** A geometry for each tube; the triangles are those of the first one. */
export function leanSplit(strokes) {
  const indices = new Uint16Array(INDICES);
  writeIndices(indices, 0, 0);
  const shared = new BufferAttribute(indices, 1); // the exporter writes it once
  return strokes.map((stroke) => {
    const arrays = arraysFor(1);
    writeVertices(stroke, arrays, 0);
    return geometryOf(arrays, shared);
  });
}
