// Plots with both axes in powers of ten.
function logPlot(figure, plot) {
  figure.textContent = '';
  const points = plot.series.flatMap((series) => series.points);
  if (!points.length) {
    figure.appendChild(document.createElement('p')).textContent = plot.title + ': ' + plot.nothing;
    return;
  }
  const BOTTOM = 62 + 22 * Math.max(3, plot.series.length), HEIGHT = 272 + BOTTOM;
  const WIDTH = 560, LEFT = 72, TOP = 34, RIGHT = 16;
  const svg = svgElement('svg', {viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'img'}, figure);
  const range = (k) => {
    const logs = points.map((p) => Math.log10(p[k]));
    const low = Math.floor(Math.min(...logs) * 2 - 0.05) / 2, high = Math.ceil(Math.max(...logs) * 2 + 0.05) / 2;
    return [low, high];
  };
  const [x0, x1] = range(0), [y0, y1] = range(1);
  const px = (x) => LEFT + (Math.log10(x) - x0) / (x1 - x0) * (WIDTH - LEFT - RIGHT);
  const py = (y) => TOP + (y1 - Math.log10(y)) / (y1 - y0) * (HEIGHT - TOP - BOTTOM);
  const write = (x, y, anchor, words, name) => {
    const element = svgElement('text', {x, y, 'text-anchor': anchor, class: name || ''}, svg);
    element.textContent = words;
    return element;
  };
  const power = (x, y, anchor, exponent) => {
    svgElement('tspan', {dy: -5, 'font-size': '75%'}, write(x, y, anchor, '10')).textContent =
        String(exponent).replace('-', '−');
  };
  const summary = plot.series.map((series) => series.label).join('; ');
  svgElement('title', {}, svg).textContent = plot.title + '. ' + summary;
  write(LEFT, 20, 'start', plot.title, 'title');
  const steps = (low, high) => {
    const step = Math.max(1, Math.ceil((high - low) / 8)), all = [];
    for (let e = Math.ceil(low); e <= high; ++e) if (e % step === 0) all.push(e);
    return all;
  };
  for (const e of steps(x0, x1)) {
    const x = px(10 ** e);
    svgElement('path', {class: 'grid', d: `M${x} ${TOP}V${HEIGHT - BOTTOM}`}, svg);
    power(x, HEIGHT - BOTTOM + 20, 'middle', e);
  }
  for (const e of steps(y0, y1)) {
    const y = py(10 ** e);
    svgElement('path', {class: 'grid', d: `M${LEFT} ${y}H${WIDTH - RIGHT}`}, svg);
    power(LEFT - 8, y + 5, 'end', e);
  }
  write((LEFT + WIDTH - RIGHT) / 2, HEIGHT - BOTTOM + 42, 'middle', plot.x);
  const middle = (TOP + HEIGHT - BOTTOM) / 2;
  write(18, middle, 'middle', plot.y).setAttribute('transform', `rotate(-90 18 ${middle})`);
  plot.series.forEach((series, i) => {
    const group = svgElement('g', {class: series.method}, svg);
    const line = series.points.map((p) => px(p[0]) + ' ' + py(p[1])).join('L');
    svgElement('path', {class: 'series', d: 'M' + line}, group);
    for (const p of series.points) svgElement('circle', {class: 'dot', cx: px(p[0]), cy: py(p[1]), r: 3.5}, group);
    const y = HEIGHT - BOTTOM + 68 + 22 * i;
    svgElement('path', {class: 'series', d: `M${LEFT} ${y - 5}h34`}, group);
    write(LEFT + 44, y, 'start', series.label);
  });
}

// The slope of the finest levels: from the last on, as long as a level's own slope is within 2 % of that of all finer
// ones together, and the sizes from which to which it is.
function finestSlope(levels, points) {
  let rise = 0, run = 0, k = levels.length;
  while (k > 0) {
    const [count, , , ds, dw] = levels[k - 1];
    if (run && Math.abs(dw / ds / (rise / run) - 1) > 0.02) break;
    rise += count * dw;
    run += count * ds;
    --k;
  }
  return {slope: rise / run, from: points[k][0], to: points[points.length - 1][0]};
}

// How thickness falls with size: from the mean of the spiral segments on, a step a level, each the mean change of the
// pieces that are halved there.
function plotSizes(figure, file, methods, names) {
  const series = methods.map((method, m) => {
    const levels = file.halvings[m].filter((level) => level[0] > 0), points = [];
    let size = 0, thickness = 0;
    levels.forEach(([, s, w, ds, dw], k) => {
      if (k === 0) points.push([size = s, thickness = w]);
      points.push([size *= Math.exp(ds), thickness *= Math.exp(dw)]);
    });
    if (!levels.length) return {method, points, label: names[method] + ': no piece is halved'};
    const fit = finestSlope(levels, points);
    return {method, points, label: `${names[method]}: slope ${fit.slope.toFixed(2)} at sizes ` +
                                   `${fit.from.toPrecision(2)} to ${fit.to.toPrecision(2)}`};
  });
  logPlot(figure, {series, title: 'Thickness against size of pieces', x: 'distance of the ends of a piece',
                   y: 'thickness', nothing: 'no piece is halved.'});
}

function plotCounts(figure, file, methods, names) {
  const series = methods.map((method, m) => {
    const points = file.rows.filter((row) => row[0] < 0 && row[1] === m).map((row) => [file.eps[row[2]], row[6]]);
    const [a, b] = points.slice(-2);
    const slope = points.length > 1 ? ': slope ' + (Math.log(b[1] / a[1]) / Math.log(b[0] / a[0])).toFixed(2) : '';
    return {method, points, label: names[method] + slope};
  });
  logPlot(figure, {series, title: 'Regions against ε', x: 'ε', y: 'leaf regions', nothing: 'no tolerance.'});
}
