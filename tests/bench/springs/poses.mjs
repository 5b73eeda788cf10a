// A pose is, for each chain, the places of its nodes relative to the head.
export const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

function direction(a, b) {
  const length = distance(a, b) || 1;
  return [(b[0] - a[0]) / length, (b[1] - a[1]) / length, (b[2] - a[2]) / length];
}

/** In degrees; by the tangent, since the cosine of small angles says nothing. */
function angleBetween(a, b) {
  const across = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  return (Math.atan2(Math.hypot(...across), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180) / Math.PI;
}

const lengthOf = (nodes) => nodes.slice(1).reduce((sum, node, i) => sum + distance(nodes[i], node), 0);

/** How far two poses are apart: the most turned bone, and the most moved node as a percentage of its chain's length. */
export function apart(pose, other) {
  let degrees = 0;
  let percent = 0;
  pose.forEach((nodes, c) => {
    const length = lengthOf(nodes);
    nodes.forEach((node, i) => {
      percent = Math.max(percent, (100 * distance(node, other[c][i])) / length);
      if (i) degrees = Math.max(degrees, angleBetween(direction(nodes[i - 1], node), direction(other[c][i - 1], other[c][i])));
    });
  });
  return { degrees, percent };
}

export const worst = (gaps) => ({ degrees: Math.max(...gaps.map((g) => g.degrees)), percent: Math.max(...gaps.map((g) => g.percent)) });

export const isFinitePose = (pose) => pose.every((nodes) => nodes.every((node) => node.every(Number.isFinite)));
