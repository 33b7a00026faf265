const say = (...words) => { document.getElementById('log').textContent += words.join(' ') + '\n'; };
// Points on what the reader made: pieces {points, weights} in the drawing.

const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);

// The point at t by de Casteljau's construction.
function pointOf({points, weights}, t) {
  let p = points.map(([x, y], i) => { const w = weights.length ? weights[i] : 1; return [x * w, y * w, w]; });
  while (p.length > 1) p = p.slice(1).map((q, i) => q.map((v, k) => (1 - t) * p[i][k] + t * v));
  return [p[0][0] / p[0][2], p[0][1] / p[0][2]];
}

const SAMPLES = 32;  // of a piece

// The distance of a point from the pieces, found from all samples that are nearer than their neighbours by halving
// steps.
function distanceFrom(pieces, p) {
  let best = Infinity;
  for (const piece of pieces) {
    const low = [0, 1].map((k) => Math.min(...piece.points.map((q) => q[k])));
    const high = [0, 1].map((k) => Math.max(...piece.points.map((q) => q[k])));
    const away = (k) => Math.max(low[k] - p[k], p[k] - high[k], 0);
    if (Math.hypot(away(0), away(1)) >= best) continue;
    const at = (t) => distance(pointOf(piece, t), p);
    const samples = [...Array(SAMPLES + 1).keys()].map((i) => at(i / SAMPLES));
    samples.forEach((sample, i) => {
      if (sample > samples[i - 1] || sample > samples[i + 1]) return;
      let t = i / SAMPLES, d = sample;
      for (let step = 0.5 / SAMPLES; step > 1e-9; step /= 2)
        for (const other of [Math.max(t - step, 0), Math.min(t + step, 1)]) {
          const nearer = at(other);
          if (nearer < d) { d = nearer; t = other; }
        }
      best = Math.min(best, d);
    });
  }
  return best;
}
