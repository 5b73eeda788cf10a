// What must hold for a file's nodes and meshes, whatever the hair.

/** Whether a file has a mesh per picture in place of skins. */
export const isFlipBook = ({ json }) => json.skins === undefined && (json.animations ?? []).some(({ channels }) => channels.some(({ target }) => target.path === "scale"));

/** @returns {string} what is wrong with a node of a flip book, or "" */
function pageFault(json, index, pages) {
  const { name, mesh, skin, translation, rotation, scale, children } = json.nodes[index];
  if (mesh === undefined) return name === "hair_root" && children.length === json.nodes.length - 1 && json.scenes[0].nodes.length === 1 ? "" : `${name} holds no picture`;
  const number = pages.push(index);
  if (skin !== undefined || translation || rotation || children) return `${name} is more than a picture`;
  const wanted = Array(3).fill(number === 1 ? 1 : 0);
  if (JSON.stringify(scale ?? [1, 1, 1]) !== JSON.stringify(wanted)) return `${name} has the scale ${scale}`;
  return name === `picture_${String(number).padStart(2, "0")}` ? "" : `picture ${number} is called ${name}`;
}

/** @returns {string} what is wrong, or "" */
export function nodeFault(glb) {
  const { json } = glb;
  if (isFlipBook(glb)) {
    const pages = [];
    return json.nodes.map((_, index) => pageFault(json, index, pages)).find((fault) => fault) ?? "";
  }
  const names = json.nodes.map((node) => node.name);
  const twice = names.find((name, i) => names.indexOf(name) !== i);
  if (twice !== undefined) return `two nodes are called ${twice}`;
  const unfit = names.find((name) => !/^[A-Za-z][A-Za-z0-9_]{0,14}$/.test(name));
  if (unfit !== undefined) return `the name ${JSON.stringify(unfit)} does not survive every tool`;
  for (const [index, node] of json.nodes.entries()) {
    const isRoot = json.scenes[0].nodes.includes(index);
    if ((node.mesh !== undefined) !== (node.skin !== undefined)) return `${node.name} has a mesh without a skin`;
    if (node.mesh !== undefined && (!isRoot || node.translation || node.rotation || node.scale || node.matrix)) return `${node.name} is no plain mesh node at the scene's root`;
    if (node.matrix) return `${node.name} has a matrix`;
  }
  return "";
}

/** Joins vertices that stand in the same place. @returns {Uint32Array} for each vertex the first one of its place */
function weld(positions) {
  const first = new Map();
  const welded = new Uint32Array(positions.length / 3);
  for (let v = 0; v < welded.length; v += 1) {
    const key = `${positions[3 * v]} ${positions[3 * v + 1]} ${positions[3 * v + 2]}`;
    if (!first.has(key)) first.set(key, v);
    welded[v] = first.get(key);
  }
  return welded;
}

/** How often each edge is walked one way more than the other: all zero where a surface has no hole. */
function openEdges(welded, indices) {
  const balance = new Map();
  const walk = (a, b, step) => {
    const key = a * welded.length + b;
    const left = (balance.get(key) ?? 0) + step;
    if (left === 0) balance.delete(key);
    else balance.set(key, left);
  };
  for (let t = 0; t < indices.length; t += 3) {
    for (let k = 0; k < 3; k += 1) {
      const a = welded[indices[t + k]];
      const b = welded[indices[t + ((k + 1) % 3)]];
      if (a < b) walk(a, b, 1);
      else if (a > b) walk(b, a, -1);
    }
  }
  return balance.size;
}

function volume(positions, indices) {
  const at = (i) => [positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]];
  let sixfold = 0;
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [at(indices[t]), at(indices[t + 1]), at(indices[t + 2])];
    sixfold += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sixfold / 6;
}

function rows(values, width, fault) {
  for (let at = 0; at < values.length; at += width) {
    const found = fault(values.subarray(at, at + width));
    if (found) return `vertex ${at / width} ${found}`;
  }
  return "";
}

/** @returns {string} what is wrong with a mesh, or "" */
export function meshFault(glb, mesh) {
  const { attributes, indices: indexAccessor } = mesh.primitives[0];
  const [positions, normals, uvs] = ["POSITION", "NORMAL", "TEXCOORD_0"].map((name) => glb.data(attributes[name]));
  if ((attributes.WEIGHTS_0 === undefined) !== isFlipBook(glb)) return "has weights where nothing bends, or none where something does";
  const weights = attributes.WEIGHTS_0 === undefined ? new Float32Array() : glb.data(attributes.WEIGHTS_0);
  const indices = glb.data(indexAccessor);
  for (const values of [positions, normals, uvs, weights]) {
    if (!values.every(Number.isFinite)) return "holds a number that is not finite";
  }
  if (indices.some((index) => index >= positions.length / 3)) return "has a triangle without its vertex";
  const open = openEdges(weld(positions), indices);
  if (open > 0) return `is open at ${open} edges`;
  if (!(volume(positions, indices) > 0)) return `has a volume of ${volume(positions, indices)}`;
  return (
    rows(normals, 3, (n) => (Math.abs(Math.hypot(...n) - 1) < 1e-5 ? "" : "has a normal that is no unit vector")) ||
    rows(weights, 4, (w) => (Math.abs(w[0] + w[1] + w[2] + w[3] - 1) < 1e-6 && w.every((part) => part >= 0) ? "" : "has weights that do not sum to 1")) ||
    rows(uvs, 2, (uv) => (uv.every((part) => part >= 0 && part <= 1) ? "" : "has a texture coordinate outside 0 to 1"))
  );
}
