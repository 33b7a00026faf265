// Panels, a method each, that show the same part of a drawing: moved and zoomed by mouse, wheel, touch and keys.
const SVG = 'http://www.w3.org/2000/svg';
function svgElement(name, attributes, parent) {
  const element = document.createElementNS(SVG, name);
  for (const key in attributes) element.setAttribute(key, attributes[key]);
  if (parent) parent.appendChild(element);
  return element;
}

// What all panels show: the middle, and how many units of the drawing are as wide as a panel.
const camera = {
  x: 0, y: 0, span: 1, whole: 1,
  fit(box, ratio) {
    const [width, height] = box;
    this.whole = 1.08 * Math.max(width, height / ratio, 1e-3);
    this.span = this.whole;
    this.x = width / 2;
    this.y = height / 2;
  },
  // Zooms about a point of a panel, given as shares of its width from the middle.
  zoom(factor, dx = 0, dy = 0) {
    const span = Math.min(Math.max(this.span / factor, this.whole * 1e-8), this.whole * 4);
    this.x += dx * (this.span - span);
    this.y += dy * (this.span - span);
    this.span = span;
  },
  move(dx, dy) {
    this.x -= dx * this.span;
    this.y -= dy * this.span;
  }
};

// Listens to a panel; changed() is called after the camera moved.
function steer(svg, changed) {
  const pointers = new Map();
  const place = (event) => {
    const box = svg.getBoundingClientRect();
    return {x: (event.clientX - box.left) / box.width - 0.5, y: (event.clientY - box.top - box.height / 2) / box.width};
  };
  const middle = (some) => {
    const all = [...some], mean = (k) => all.reduce((sum, p) => sum + p[k], 0) / all.length;
    const x = mean('x'), y = mean('y');
    return {x, y, spread: all.reduce((s, p) => s + Math.hypot(p.x - x, p.y - y), 0)};
  };
  svg.addEventListener('pointerdown', (event) => {
    pointers.set(event.pointerId, place(event));
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener('pointermove', (event) => {
    if (!pointers.has(event.pointerId)) return;
    const before = middle(pointers.values());
    pointers.set(event.pointerId, place(event));
    const after = middle(pointers.values());
    camera.move(after.x - before.x, after.y - before.y);
    if (before.spread > 0 && after.spread > 0) camera.zoom(after.spread / before.spread, after.x, after.y);
    changed();
  });
  for (const end of ['pointerup', 'pointercancel'])
    svg.addEventListener(end, (event) => pointers.delete(event.pointerId));
  svg.addEventListener('wheel', (event) => {
    event.preventDefault();
    const p = place(event), lines = event.deltaMode === 1 ? 16 : 1;
    camera.zoom(Math.exp(-event.deltaY * lines * 0.002), p.x, p.y);
    changed();
  }, {passive: false});
  svg.addEventListener('keydown', (event) => {
    const moves = {ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]};
    if (moves[event.key]) camera.move(...moves[event.key]);
    else if (event.key === '+' || event.key === '=') camera.zoom(1.5);
    else if (event.key === '-') camera.zoom(1 / 1.5);
    else if (event.key === '0') document.getElementById('fit').click();
    else return;
    event.preventDefault();
    changed();
  });
}

const PATHS = ['regions', 'curves', 'chosen', 'inner', 'outer', 'joints', 'ends'];

function makePanel(method, name, changed) {
  const panel = document.createElement('figure');
  panel.className = 'panel ' + method;
  const caption = panel.appendChild(document.createElement('figcaption'));
  caption.appendChild(document.createElement('b')).textContent = name;
  const count = caption.appendChild(document.createElement('output'));
  count.id = 'count-' + method;
  const svg = svgElement('svg', {tabindex: 0, role: 'img'}, panel);
  const paths = {};
  for (const path of PATHS) paths[path] = svgElement('path', {class: path}, svg);
  const answers = svgElement('g', {class: 'answers'}, svg);
  steer(svg, changed);
  return {panel, svg, paths, answers, count, method, name};
}

// How wide dots are: at most half as wide as regions in sight are long, so that they hide nothing; 0 where they would
// be too small to be told apart from the curves.
function dotWidth(view, nodes, largest) {
  if (!nodes.length) return largest;
  const lengths = nodes.map((n) => view.scale * Math.hypot(n.x1 - n.x0, n.y1 - n.y0)).sort((a, b) => a - b);
  const width = Math.min(largest, lengths[lengths.length >> 1] / 2);
  return width < 1.5 ? 0 : width;
}

// Draws what is in sight. shown: the nodes; layers: which are on.
function drawPanel(panel, curves, shown, layers, chosen, overlays) {
  const width = panel.svg.clientWidth || 600, height = panel.svg.clientHeight || 400;
  panel.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  const view = makeView(camera.x, camera.y, width / camera.span, width, height);
  const seen = shown.filter((node) => isNodeInSight(view, node));
  const set = (path, on, d) => panel.paths[path].setAttribute('d', on ? d() : '');
  const join = (items, path) => items.map(path).join('');
  const dots = (nodes) => join(nodes, (node) => startOf(view, node) + 'h0');
  set('regions', layers.regions, () => join(seen, (node) => regionPath(view, node)));
  set('inner', layers.inner, () => join(seen, (node) => chainPath(view, node, node.inner)));
  set('outer', layers.outer, () => join(seen, (node) => chainPath(view, node, node.outer)));
  set('joints', layers.ends, () => dots(seen.filter((node) => !node.startsSpiral)));
  set('ends', layers.ends, () => dots(seen.filter((node) => node.startsSpiral)) +
      join(seen.filter((node) => node.endsCurve), (node) => endOf(view, node) + 'h0'));
  const dot = dotWidth(view, seen, 4.5);
  panel.paths.joints.setAttribute('stroke-width', dot);
  panel.paths.ends.setAttribute('stroke-width', dot * 1.2);
  const pieces = (some) => join(some, (curve) => join(curve.pieces, (piece) => curvePath(view, piece)));
  set('curves', layers.curves, () => pieces(curves));
  set('chosen', chosen, () => pieces([chosen]));
  panel.answers.textContent = '';
  overlays.forEach((overlay, i) => { if (layers['answer' + i]) drawAnswer(panel.answers, view, overlay, i); });
}

// An answer's marks are [kind, [x, y, ...]], of kinds dot, strong dot, line and strong line.
const ANSWER_COLOURS = 4;
function drawAnswer(parent, view, overlay, number) {
  const DOT = 0, STRONG_DOT = 1, LINE = 2, STRONG_LINE = 3;
  const group = svgElement('g', {class: 'answer' + number % ANSWER_COLOURS}, parent);
  const points = (flat) => {
    const all = [];
    for (let i = 0; i < flat.length; i += 2) all.push(text(view.x(flat[i]), view.y(flat[i + 1])));
    return all;
  };
  const path = (kinds) => overlay.marks.filter((mark) => kinds.includes(mark[0])).map(([kind, flat]) =>
      'M' + points(flat).join('L') + (kind === DOT || kind === STRONG_DOT ? 'h0' : '')).join('');
  const chains = overlay.chains.map((chain) => arcsPath(view, chain)).join('');
  svgElement('path', {class: 'answer strong', d: path([STRONG_LINE])}, group);
  svgElement('path', {class: 'answer', d: path([LINE]) + chains}, group);
  svgElement('path', {class: 'answer dots', d: path([DOT, STRONG_DOT])}, group);
}
