// Holds the reader's curves against the browser's outlines, element by element: the same subpaths of the same pieces,
// in the same places. `drawings` has, for each, its file, its text and the reader's curves.

// Coordinates are single precision in the browser, through a few operations. It prints path data with six digits, and
// points that it finds on cubics were seen up to 7e-5 of a coordinate away from them. Elliptical arcs of paths are
// drawn as cubics, which miss them by 2.8e-4 of a radius; their centers move by the root of the chord's rounding.
const ROUNDING = 2 ** -24, SINGLE_PRECISION = 8 * ROUNDING, SIX_DIGITS = 5e-6, ON_CUBICS = 1e-4;
const arcDoubt = (radius, greatest) => radius > 0 ? radius * (3e-4 + Math.sqrt(4 * ROUNDING * greatest / radius)) : 0;
const POINTS_PER_PIECE = 4;  // that are asked of the browser

const SHAPES = 'path, rect, circle, ellipse, line, polyline, polygon';

// What makes no box is not displayed. What is not visible makes one, and so do viewports without size, in which the
// browser draws nothing.
function isDrawn(element, root) {
  for (let svg = element.ownerSVGElement; svg && svg !== root; svg = svg.ownerSVGElement)
    if (!(svg.width.baseVal.value > 0 && svg.height.baseVal.value > 0)) return false;
  return element.getClientRects().length > 0 && getComputedStyle(element).visibility === 'visible';
}

// Takes the pieces off `rest` that make the segment, whose points are in the drawing; tells what is wrong, or ''. A
// segment that is a point has one only where nothing else is.
function takeSegment(rest, {kind, points}, near) {
  const end = points[points.length - 1], isPoint = (list) => list.every((q) => distance(q, end) <= near);
  if (isPoint(points) && (rest.length === 0 || !isPoint(rest[0].points))) return '';
  if (rest.length === 0) return `no piece for a ${kind}`;
  for (let pieces = 0; kind === 'arc'; ++pieces) {
    if (pieces === 4 || rest.length === 0) return `no end of an arc at ${end}`;
    const {points: p, weights} = rest.shift();
    if (weights.length !== 3) return 'an arc is no rational quadratic';
    if (distance(p[2], end) <= near) return '';
  }
  const {points: p, weights} = rest.shift();
  if (weights.length > 0 || p.length !== points.length) return `${p.length} control points instead of a ${kind}`;
  const miss = Math.max(...p.map((q, i) => distance(q, points[i])));
  return miss <= near ? '' : `a ${kind} to ${end} is ${miss} away, more than ${near}`;
}

// Compares what the browser knows of an element with the reader's curves of it, and counts.
function compareElement(element, root, curves, count, say) {
  const matrix = root.getScreenCTM().inverse().multiply(element.getScreenCTM());
  const place = ([x, y]) => [matrix.a * x + matrix.c * y + matrix.e, matrix.b * x + matrix.d * y + matrix.f];
  const scale = Math.hypot(matrix.a, matrix.b, matrix.c, matrix.d), shift = Math.hypot(matrix.e, matrix.f);
  const wanted = subpathsOf(element), segments = wanted.flatMap((subpath) => subpath.segments);
  const greatest = Math.max(0, ...segments.flatMap(({points}) => points.flat().map(Math.abs)));
  const radius = Math.max(0, ...segments.map((segment) => segment.radius));
  const rounding = SINGLE_PRECISION * (scale * greatest + shift);
  const printed = rounding + (element.localName === 'path' ? SIX_DIGITS * scale * greatest : 0);
  const found = curves.splice(0, wanted.length);
  if (found.length < wanted.length) return say(`${wanted.length} subpaths, ${found.length} left`);
  wanted.forEach((subpath, i) => {
    const rest = [...found[i].pieces];
    if (found[i].closed !== subpath.closed) say(`${found[i].name} is ${found[i].closed ? '' : 'not '}closed`);
    for (const {kind, points, unsure} of subpath.segments) {
      const wrong = takeSegment(rest, {kind, points: points.map(place)}, unsure * printed);
      if (wrong) return say(`${found[i].name}: ${wrong}`);
    }
    if (rest.length > 0) say(`${found[i].name}: ${rest.length} pieces more`);
  });
  count.subpaths += wanted.length;
  const pieces = found.flatMap((curve) => curve.pieces);
  count.pieces += pieces.length;
  if (pieces.length > 0 && (element.localName !== 'path' || radius > 0)) {
    const doubt = element.localName === 'path' ? ON_CUBICS * greatest + arcDoubt(radius, greatest) : 0;
    comparePoints(element, place, pieces, rounding + scale * doubt, say);
  }
}

// What commands do not tell, ellipses and corners: points that the browser finds along its outline are on ours.
function comparePoints(element, place, pieces, allowed, say) {
  const length = element.getTotalLength(), asked = POINTS_PER_PIECE * pieces.length;
  for (let i = 0; i < asked; ++i) {
    const {x, y} = element.getPointAtLength(length * (i + 0.5) / asked), miss = distanceFrom(pieces, place([x, y]));
    if (!(miss <= allowed)) return say(`${place([x, y])} is ${miss} away, more than ${allowed}`);
  }
}

async function compareDrawing({file, text, curves}) {
  const tell = (...words) => say(`${file}:`, ...words);
  const bytes = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const encoding = new TextDecoder('latin1').decode(bytes).match(/^<\?xml[^>]*encoding=["']([^"']*)/);
  const parsed = new DOMParser().parseFromString(new TextDecoder(encoding ? encoding[1] : 'utf-8').decode(bytes),
                                                 'image/svg+xml');
  const root = document.importNode(parsed.documentElement, true);
  for (const element of root.querySelectorAll('style, script')) element.remove();  // which the reader does not read
  document.getElementById('host').replaceChildren(root);
  const ink = await comparePictures(root, curves, tell);
  expandUses(root, tell);
  const count = {subpaths: 0, pieces: 0}, rest = [...curves];
  const elements = [...root.querySelectorAll(SHAPES)].filter((element) => isDrawn(element, root));
  elements.forEach((element, i) => compareElement(element, root, rest, count, (...words) =>
    tell(`<${element.localName} id="${element.id}">, element ${i + 1}:`, ...words)));
  if (rest.length > 0) tell(`${rest.length} curves that the browser does not have, the first ${rest[0].name}`);
  say(`compared: ${file}: ${elements.length} elements, ${count.subpaths} subpaths, ${count.pieces} pieces, ` +
      `${ink} pixels`);
}

(async () => {
  for (const drawing of drawings)
    try { await compareDrawing(drawing); } catch (error) { say(`${drawing.file}: ${error.stack}`); }
  say('end');
})();
