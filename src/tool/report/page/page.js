// The page: what is chosen, and what it shows.
(() => {
  const data = JSON.parse(document.getElementById('data').textContent), methods = data.methods;
  const NAMES = {bca: 'BCA', sfa: 'SFA', bilens: 'bilens', 'fat-arc': 'fat arcs', 'fat-biarc': 'fat biarcs',
                 box: 'boxes', 'oriented-box': 'oriented boxes', hull: 'hulls'};
  const LAYERS =
      {curves: 'curves', regions: 'regions', inner: 'inner boundaries', outer: 'outer boundaries', ends: 'ends'};
  const $ = (id) => document.getElementById(id);
  let file, trees, tolerance = 0, level = 0, curve = -1, frame = 0;
  const layers = {};

  const changed = () => { if (!frame) frame = requestAnimationFrame(draw); };
  const panels = methods.map((method) => makePanel(method, NAMES[method], changed));
  for (const panel of panels) $('panels').appendChild(panel.panel);

  function checkbox(parent, id, label, isOn, change) {
    const element = parent.appendChild(document.createElement('label'));
    const input = element.appendChild(document.createElement('input'));
    Object.assign(input, {type: 'checkbox', id, checked: isOn});
    input.addEventListener('change', () => { change(input.checked); changed(); });
    element.append(label);
    return element;
  }
  function options(select, names) {
    select.textContent = '';
    names.forEach((name, i) => select.add(new Option(name, i)));
  }

  // The nodes shown now, of all curves or of the one that is chosen.
  const shown = (method) => trees.curves.flatMap((c) => c.nodes[method].filter((n) => isShown(n, tolerance, level)));

  function draw() {
    frame = 0;
    const chosen = curve >= 0 ? trees.curves[curve] : null;
    for (const panel of panels) {
      if (panel.panel.hidden) continue;
      const nodes = file.drawn ? shown(panel.method) : [];
      const thickest = nodes.reduce((most, node) => Math.max(most, node.thickness), 0);
      panel.count.textContent = file.drawn ?
          `${nodes.length} region${nodes.length === 1 ? '' : 's'}, the thickest ${short(thickest)}` : '';
      panel.count.dataset.regions = nodes.length;
      panel.svg.setAttribute('aria-label', `${panel.name}, ${file.name}: ${panel.count.textContent}`);
      drawPanel(panel, trees.curves, nodes, layers, chosen, file.overlays);
    }
    const zoom = camera.whole / camera.span;
    $('zoom-value').textContent = zoom < 1000 ? `zoom ${Number(zoom.toPrecision(3))}` : `zoom ${zoom.toExponential(1)}`;
  }

  function showLevels() {
    const deepest = trees.levels[tolerance] || 0;
    $('level').max = deepest;
    $('level').value = level = Math.min(level, deepest);
    const words = level === deepest ? `${level} of ${deepest}: all leaves` : `${level} of ${deepest}`;
    $('level-value').textContent = words;
    $('level').setAttribute('aria-valuetext', words);
  }
  function showTolerance() {
    const words = file.drawn ? short(file.eps[tolerance]) : 'none is drawn';
    $('eps-value').textContent = words;
    $('eps').setAttribute('aria-valuetext', words);
    showComparison($('table'), file, methods, NAMES, curve, tolerance);
  }

  function open(index) {
    file = data.files[index];
    trees = readFile(file, methods);
    tolerance = Math.max(0, Math.min(2, file.drawn - 1));
    level = Infinity;
    curve = -1;
    const count = (n, noun) => `${n} ${noun}${n === 1 ? '' : 's'}`;
    const sum = (key) => file.curves.reduce((s, c) => s + c[key], 0);
    $('facts').textContent = `${file.name}: ${count(file.number, 'curve')}` +
        (file.curves.length === file.number ? `, ${count(sum('beziers'), 'Bézier piece')}, ` +
         count(sum('spirals'), 'spiral segment') : '') + `; ${data.kernel} kernel.`;
    $('notes').textContent = '';
    $('notes').hidden = !file.notes.length;
    for (const note of file.notes) $('notes').appendChild(document.createElement('li')).textContent = note;
    $('eps').max = Math.max(0, file.drawn - 1);
    $('eps').value = tolerance;
    $('eps').disabled = $('level').disabled = !file.drawn;

    const named = file.rows.some((row) => row[0] >= 0) && file.number > 1;
    options($('curve'), ['all'].concat(named ? file.curves.map((c, i) => `${i + 1}: ${c.name}`) : []));
    $('curve-pick').hidden = !named;
    $('layers').querySelectorAll('label').forEach((label) => label.remove());
    const all = {...LAYERS};
    file.overlays.forEach((overlay, i) => { all['answer' + i] = overlay.title; });
    for (const key in all) {
      if (!(key in layers)) layers[key] = key !== 'inner' && key !== 'outer';
      const label = checkbox($('layers'), 'layer-' + key, all[key], layers[key], (isOn) => { layers[key] = isOn; });
      if (!key.startsWith('answer')) continue;
      label.appendChild(document.createElement('span')).className =
          'swatch answer' + Number(key.slice('answer'.length)) % ANSWER_COLOURS;
    }
    $('answers').hidden = !file.overlays.length;
    showAnswers($('answers-list'), file.overlays);
    plotSizes($('sizes'), file, methods, NAMES);
    plotCounts($('counts'), file, methods, NAMES);
    fit();
    showLevels();
    showTolerance();
    draw();
  }
  function fit() {
    const [width, height] = file.box, ratio = Math.min(Math.max(height / width || 1, 0.45), 1.1);
    for (const panel of panels) panel.svg.style.aspectRatio = `1 / ${ratio}`;
    camera.fit(file.box, ratio);
    changed();
  }

  options($('file'), data.files.map((f) => f.name));
  $('file-pick').hidden = data.files.length === 1;
  $('file').addEventListener('change', () => open(Number($('file').value)));
  $('curve').addEventListener('change', () => { curve = Number($('curve').value) - 1; showTolerance(); changed(); });
  $('eps').addEventListener('input', () => {
    const wasWhole = level === (trees.levels[tolerance] || 0);  // all leaves stay all leaves
    tolerance = Number($('eps').value);
    if (wasWhole) level = Infinity;
    showLevels();
    showTolerance();
    changed();
  });
  $('level').addEventListener('input', () => { level = Number($('level').value); showLevels(); changed(); });
  for (const panel of panels)
    checkbox($('methods'), 'method-' + panel.method, NAMES[panel.method], true,
             (isOn) => { panel.panel.hidden = !isOn; });
  $('zoom-in').addEventListener('click', () => { camera.zoom(2); changed(); });
  $('zoom-out').addEventListener('click', () => { camera.zoom(0.5); changed(); });
  $('fit').addEventListener('click', fit);
  new ResizeObserver(changed).observe($('panels'));
  window.addEventListener('beforeprint', draw);
  $('table-help').textContent = 'Cut: control points to spiral segments; build: these to the trees; arcs: those of ' +
      `the leaves in memory; the shortest of ${data.repeat} measurements each, and their sum. Ratio: regions over ` +
      `those of ${NAMES[methods[0]]}. Thickness: of the thickest leaf.`;
  if (data.stability) $('stability-plot').src = 'data:image/svg+xml,' + encodeURIComponent(data.stability);
  $('stability').hidden = !data.stability;
  open(0);
})();
