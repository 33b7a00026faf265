'use strict';
// The trees of a report's data. All tolerances have one tree: that of a larger tolerance is its upper part.

// The nodes of a curve by one method. flat: for each node, before those below it, the number of the smallest tolerance
// for which it is a leaf (-1: none), its thickness, its inner and its outer chain, and the point in which it is halved,
// where it is. ends: where each spiral segment starts and ends. A node is there from the tolerance `since` on.
function readNodes(flat, ends, tolerances) {
  const nodes = [];
  let at = 0;
  const read = (level, since, startsSpiral, endsCurve, x0, y0, x1, y1) => {
    const [leaf, thickness, inner, outer] = flat.slice(at, at + 4);
    at += 4;
    nodes.push({level, since, leaf, thickness, inner, outer, startsSpiral, endsCurve, x0, y0, x1, y1});
    if (leaf === tolerances - 1) return;
    const x = flat[at], y = flat[at + 1], below = Math.max(since, leaf + 1);
    at += 2;
    read(level + 1, below, startsSpiral, false, x0, y0, x, y);
    read(level + 1, below, false, endsCurve, x, y, x1, y1);
  };
  for (let i = 0; i < ends.length; i += 4)
    read(0, 0, true, i + 4 === ends.length, ends[i], ends[i + 1], ends[i + 2], ends[i + 3]);
  return nodes;
}

// Whether a node is one of the regions shown: a leaf of the tolerance's tree, or cut off at the level.
function isShown(node, tolerance, level) {
  if (node.since > tolerance || node.level > level) return false;
  return node.leaf >= tolerance || node.level === level;
}

// A file's curves with their nodes by each method, and the deepest level for each tolerance.
function readFile(file, methods) {
  const levels = file.eps.slice(0, file.drawn).map(() => 0);
  const curves = file.curves.map((curve) => {
    const nodes = {};
    methods.forEach((method, m) => {
      nodes[method] = file.drawn ? readNodes(curve.nodes[m], curve.ends, file.drawn) : [];
      for (const node of nodes[method])
        for (let e = node.since; e <= node.leaf; ++e) levels[e] = Math.max(levels[e], node.level);
    });
    return {name: curve.name, pieces: curve.pieces, nodes};
  });
  return {curves, levels};
}
