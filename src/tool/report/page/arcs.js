// Arcs and curves as SVG paths in pixels. Numbers in SVG are floats of single precision: what is far larger than the
// picture is halved until its parts are small, or out of sight and drawn as lines.
const FAR = 4000;  // pixels

// A view: the point of the drawing in the middle, pixels a unit, and the size of the picture.
function makeView(x, y, scale, width, height) {
  return {x: (v) => (v - x) * scale + width / 2, y: (v) => (v - y) * scale + height / 2, scale, width, height};
}
function inSight(view, x0, y0, x1, y1, margin) {
  return Math.max(x0, x1) + margin >= 0 && Math.min(x0, x1) - margin <= view.width &&
         Math.max(y0, y1) + margin >= 0 && Math.min(y0, y1) - margin <= view.height;
}
const text = (x, y) => x.toFixed(2) + ' ' + y.toFixed(2);

// From where the path is to (x1, y1), all in pixels. Bulges are positive clockwise, as y is downwards.
function arcTo(view, x0, y0, bulge, x1, y1) {
  const b = Math.abs(bulge), chord = Math.hypot(x1 - x0, y1 - y0), height = b * chord / 2;
  if (height < 0.01 || !inSight(view, x0, y0, x1, y1, Math.max(height, chord * b))) return 'L' + text(x1, y1);
  if (chord > FAR) {
    const half = bulge / (1 + Math.sqrt(1 + bulge * bulge));
    const x = (x0 + x1) / 2 + bulge / 2 * (y1 - y0), y = (y0 + y1) / 2 - bulge / 2 * (x1 - x0);
    return arcTo(view, x0, y0, half, x, y) + arcTo(view, x, y, half, x1, y1);
  }
  const r = (chord * (1 + b * b) / (4 * b)).toFixed(2);
  return `A${r} ${r} 0 ${b > 1 ? 1 : 0} ${bulge > 0 ? 1 : 0} ` + text(x1, y1);
}

// A chain of a node: a bulge, or the joints and then the bulges of several pieces.
function chainTo(view, node, chain, forwards) {
  const [x0, y0, x1, y1] = forwards ? [node.x0, node.y0, node.x1, node.y1] : [node.x1, node.y1, node.x0, node.y0];
  const arc = (xa, ya, b, xb, yb) =>
      arcTo(view, view.x(xa), view.y(ya), forwards ? b : -b, view.x(xb), view.y(yb));
  if (!Array.isArray(chain)) return arc(x0, y0, chain, x1, y1);
  const joints = (chain.length - 1) / 3, order = [...Array(joints + 1).keys()];  // of the pieces
  if (!forwards) order.reverse();
  let path = '', x = x0, y = y0;
  for (const i of order) {
    const next = forwards ? i : i - 1, isLast = next < 0 || next === joints;
    const xb = isLast ? x1 : chain[2 * next], yb = isLast ? y1 : chain[2 * next + 1];
    path += arc(x, y, chain[2 * joints + i], xb, yb);
    [x, y] = [xb, yb];
  }
  return path;
}
const startOf = (view, node) => 'M' + text(view.x(node.x0), view.y(node.y0));
const endOf = (view, node) => 'M' + text(view.x(node.x1), view.y(node.y1));
function chainPath(view, node, chain) { return startOf(view, node) + chainTo(view, node, chain, true); }
function regionPath(view, node) {
  return startOf(view, node) + chainTo(view, node, node.outer, true) + chainTo(view, node, node.inner, false) + 'Z';
}
// Whether a node may be in sight. No point of a region is farther from its box of two ends than their distance.
function isNodeInSight(view, node) {
  const x0 = view.x(node.x0), y0 = view.y(node.y0), x1 = view.x(node.x1), y1 = view.y(node.y1);
  return inSight(view, x0, y0, x1, y1, Math.hypot(x1 - x0, y1 - y0) + 8);
}

// A chain of arcs [x, y, bulge, x, y, bulge, ..., x, y].
function arcsPath(view, chain) {
  let path = 'M' + text(view.x(chain[0]), view.y(chain[1]));
  for (let i = 2; i < chain.length; i += 3)
    path += arcTo(view, view.x(chain[i - 2]), view.y(chain[i - 1]), chain[i], view.x(chain[i + 1]),
                  view.y(chain[i + 2]));
  return path;
}

// A Bezier curve by de Casteljau's halving of [x w, y w, w]. Small curves of degree at most 3 without weights are as
// SVG has them.
function halve(points) {
  const left = [], right = [];
  for (let row = points; row.length; row = row.slice(1).map((p, i) => p.map((v, k) => (v + row[i][k]) / 2))) {
    left.push(row[0]);
    right.unshift(row[row.length - 1]);
  }
  return [left, right];
}
function bezierTo(view, points, isPlain) {
  const xs = points.map((p) => p[0] / p[2]), ys = points.map((p) => p[1] / p[2]), n = points.length - 1;
  const x0 = Math.min(...xs), x1 = Math.max(...xs), y0 = Math.min(...ys), y1 = Math.max(...ys);
  if (!inSight(view, x0, y0, x1, y1, 2) || n === 1) return 'L' + text(xs[n], ys[n]);
  const size = Math.max(x1 - x0, y1 - y0);
  if (isPlain && n <= 3 && size < FAR)
    return (n === 2 ? 'Q' : 'C') + xs.slice(1).map((x, i) => text(x, ys[i + 1])).join(' ');
  let off = 0;  // of control points from the chord: the curve is nearer
  for (let i = 1; i < n; ++i)
    off = Math.max(off, Math.hypot(xs[i] - xs[0] - (xs[n] - xs[0]) * i / n, ys[i] - ys[0] - (ys[n] - ys[0]) * i / n));
  if (off < 0.1 || size < 0.1) return 'L' + text(xs[n], ys[n]);
  return halve(points).map((half) => bezierTo(view, half, isPlain)).join('');
}
function curvePath(view, piece) {
  const flat = piece.p || piece, points = [];
  for (let i = 0; i < flat.length; i += 2) {
    const w = piece.w ? piece.w[i / 2] : 1;
    points.push([view.x(flat[i]) * w, view.y(flat[i + 1]) * w, w]);
  }
  return 'M' + text(view.x(flat[0]), view.y(flat[1])) + bezierTo(view, points, !piece.w);
}
