// The chains of a file, in the order in which they were asked for.

/** Node indices of every chain, root first, tip last. @param lengths  nodes per chain, as the JSON answer tells */
export function chainNodes(json, lengths) {
  const root = json.nodes.findIndex((node) => node.name === "hair_root");
  return (json.nodes[root].children ?? []).map((first, c) => {
    const nodes = [];
    for (let at = first; at !== undefined; at = json.nodes[at].children?.[0]) nodes.push(at);
    // A chain that hangs on a turned node has that one before its root.
    return nodes.slice(nodes.length - lengths[c]);
  });
}

/** The objects that three.js made of the file's nodes. */
export function objectsByNode(gltf) {
  const objects = [];
  for (const [object, place] of gltf.parser.associations) {
    if (place?.nodes !== undefined && object.isObject3D) objects[place.nodes] = object;
  }
  return objects;
}

/** The model-space rest place and rotation of every node, from the file. @returns {Map<number, { position: number[], rotation: number[] }>} */
export function restPoses(json) {
  const poses = new Map();
  const visit = (index, parent) => {
    const { translation = [0, 0, 0], rotation = [0, 0, 0, 1], children = [] } = json.nodes[index];
    const pose = { position: add(parent.position, turned(parent.rotation, translation)), rotation: product(parent.rotation, rotation) };
    poses.set(index, pose);
    for (const child of children) visit(child, pose);
  };
  for (const index of json.scenes[0].nodes) visit(index, { position: [0, 0, 0], rotation: [0, 0, 0, 1] });
  return poses;
}

/** The picture on show at each frame of one cycle. */
export const shownPictures = (schedule) => schedule.holds.flatMap((hold, picture) => Array(hold).fill(picture));

/** Seconds of a frame, from a number or a fraction. */
export function secondsOf(frame, fps) {
  const [numerator, denominator = 1] = String(fps).split("/").map(Number);
  return (frame * denominator) / numerator;
}

/** The length of a chain from its nodes' places, metres; 1 where it has none. */
export const lengthOf = (places) => places.reduce((sum, place, i) => (i === 0 ? 0 : sum + distance(place, places[i - 1])), 0) || 1;

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const distance = (a, b) => Math.hypot(...subtract(a, b));
export const inverse = ([x, y, z, w]) => [-x, -y, -z, w];

/** The rotation b followed by the rotation a, x y z w. */
export function product(a, b) {
  return [
    a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
    a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
    a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
    a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
  ];
}

export function turned(q, v) {
  const t = [2 * (q[1] * v[2] - q[2] * v[1]), 2 * (q[2] * v[0] - q[0] * v[2]), 2 * (q[0] * v[1] - q[1] * v[0])];
  return [v[0] + q[3] * t[0] + q[1] * t[2] - q[2] * t[1], v[1] + q[3] * t[1] + q[2] * t[0] - q[0] * t[2], v[2] + q[3] * t[2] + q[0] * t[1] - q[1] * t[0]];
}
