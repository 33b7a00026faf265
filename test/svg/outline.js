// The outline of an element as the browser has it: subpaths of segments {kind, points, unsure, radius}, the points
// being the control points from the first on, in the coordinates of the element. Coordinates of path data are printed
// with six digits by the browser; `unsure` is how many such roundings a mirrored control point adds up. The radius is
// that of an arc of a path; that of other segments is 0.

const numberOf = (element, name) => element[name].baseVal.value;

// A radius that is not given is that of the other axis.
function radiusOf(element, name, other) {
  const given = [name, other].find((radius) =>
    element.hasAttribute(radius) && element.getAttribute(radius) !== 'auto' && numberOf(element, radius) >= 0);
  return given ? numberOf(element, given) : 0;
}

// An ellipse starts at its right end and turns as the y-axis does; so does a rectangle, on the side of least y.
function ellipseData(cx, cy, rx, ry) {
  if (!(rx > 0 && ry > 0)) return [];
  const quarter = (x, y) => ['A', rx, ry, 0, 0, 1, x, y];
  return [['M', cx + rx, cy], quarter(cx, cy + ry), quarter(cx - rx, cy), quarter(cx, cy - ry), quarter(cx + rx, cy),
          ['Z']];
}

function rectData(element) {
  const [x, y, w, h] = ['x', 'y', 'width', 'height'].map((name) => numberOf(element, name));
  if (!(w > 0 && h > 0)) return [];
  const rx = Math.min(radiusOf(element, 'rx', 'ry'), w / 2), ry = Math.min(radiusOf(element, 'ry', 'rx'), h / 2);
  if (rx === 0 || ry === 0) return [['M', x, y], ['H', x + w], ['V', y + h], ['H', x], ['Z']];
  const quarter = (dx, dy) => ['A', rx, ry, 0, 0, 1, dx, dy];
  const side = (letter, length, to) => length > 0 ? [[letter, to]] : [];
  const wide = w - 2 * rx, high = h - 2 * ry;
  return [['M', x + rx, y], ...side('H', wide, x + w - rx), quarter(x + w, y + ry), ...side('V', high, y + h - ry),
          quarter(x + w - rx, y + h), ...side('H', wide, x + rx), quarter(x, y + h - ry), ...side('V', high, y + ry),
          quarter(x + rx, y), ['Z']];
}

// The greater radius of an arc from a point, whose radii grow where they do not reach (SVG 2, appendix B.2.5).
function radiusOfArc([rx, ry, degrees, , , x, y], from) {
  const angle = degrees * Math.PI / 180, dx = (x - from[0]) / 2, dy = (y - from[1]) / 2;
  const along = (dx * Math.cos(angle) + dy * Math.sin(angle)) / rx;
  const across = (dy * Math.cos(angle) - dx * Math.sin(angle)) / ry;
  return Math.max(rx, ry) * Math.max(1, Math.hypot(along, across));
}

// Commands with absolute coordinates.
function commandsOf(element) {
  switch (element.localName) {
    case 'path':
      return [...getComputedStyle(element).d.matchAll(/([MLHVCSQTAZ])([^A-Z"]*)/g)].map(
        ([, letter, numbers]) => [letter, ...(numbers.match(/[-+.\d][-+.\de]*/g) || []).map(Number)]);
    case 'line':
      return [['M', numberOf(element, 'x1'), numberOf(element, 'y1')],
              ['L', numberOf(element, 'x2'), numberOf(element, 'y2')]];
    case 'rect':
      return rectData(element);
    case 'circle':
      return ellipseData(numberOf(element, 'cx'), numberOf(element, 'cy'), numberOf(element, 'r'),
                         numberOf(element, 'r'));
    case 'ellipse':
      return ellipseData(numberOf(element, 'cx'), numberOf(element, 'cy'), radiusOf(element, 'rx', 'ry'),
                         radiusOf(element, 'ry', 'rx'));
    default: {  // polyline, polygon
      const points = [...element.points].map((p, i) => [i === 0 ? 'M' : 'L', p.x, p.y]);
      return element.localName === 'polygon' && points.length > 0 ? [...points, ['Z']] : points;
    }
  }
}

function subpathsOf(element) {
  const subpaths = [];
  let start = [0, 0], current = start, open = null, mirrored = null;
  const draw = (kind, points, unsure = 1, radius = 0) => {
    if (!open) subpaths.push(open = {segments: [], closed: false});
    open.segments.push({kind, points: [current, ...points], unsure, radius});
    current = points[points.length - 1];
  };
  const reflection = (kind) => mirrored && mirrored.kind === kind
    ? {point: [2 * current[0] - mirrored.point[0], 2 * current[1] - mirrored.point[1]], unsure: mirrored.unsure + 2}
    : {point: current, unsure: 1};
  for (const [letter, ...v] of commandsOf(element)) {
    let next = null;  // what the next command would mirror
    const pairs = [];
    for (let i = 0; i + 1 < v.length; i += 2) pairs.push([v[i], v[i + 1]]);
    if (letter === 'M') { start = current = pairs[0]; open = null; }
    else if (letter === 'L') draw('line', pairs);
    else if (letter === 'H') draw('line', [[v[0], current[1]]]);
    else if (letter === 'V') draw('line', [[current[0], v[0]]]);
    else if (letter === 'C') { draw('cubic', pairs); next = {kind: 'cubic', point: pairs[1], unsure: 1}; }
    else if (letter === 'Q') { draw('quadratic', pairs); next = {kind: 'quadratic', point: pairs[0], unsure: 1}; }
    else if (letter === 'S') {
      const {point, unsure} = reflection('cubic');
      draw('cubic', [point, ...pairs], unsure);
      next = {kind: 'cubic', point: pairs[0], unsure: 1};
    } else if (letter === 'T') {
      const {point, unsure} = reflection('quadratic');
      draw('quadratic', [point, ...pairs], unsure);
      next = {kind: 'quadratic', point, unsure};
    } else if (letter === 'A') {
      const end = [v[5], v[6]];
      if (v[0] === 0 || v[1] === 0) draw('line', [end]);
      else if (end[0] !== current[0] || end[1] !== current[1]) draw('arc', [end], 1, radiusOfArc(v, current));
    } else if (letter === 'Z') {
      if (open) { draw('close', [start]); open.closed = true; }
      current = start;
      open = null;
    }
    mirrored = next;
  }
  return subpaths;
}
