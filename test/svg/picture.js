// The drawing and the reader's curves as two pictures of thin lines: where one has ink the other has, too. What lies
// outside of the root's viewport is in neither.

const HAIRLINES = `* { fill: none !important; stroke: black !important; stroke-width: 1px !important;
  vector-effect: non-scaling-stroke !important; stroke-dasharray: none !important; stroke-linecap: butt !important;
  opacity: 1 !important; stroke-opacity: 1 !important; clip-path: none !important; mask: none !important;
  filter: none !important; marker: none !important; stroke-linejoin: bevel !important }
  svg:not([width='0']):not([height='0']), symbol { overflow: visible !important }
  text, image, foreignObject { display: none !important }`;
const WIDTH = 1000, INK = 128, TRACE = 16;  // pixels, and darkness out of 255

function curvesPicture(root, curves) {
  const svg = root.cloneNode(false);
  const d = curves.map(({pieces}) => 'M' + pieces.map((piece, i) => {
    const steps = piece.points.length === 2 ? 1 : 32;
    return [...Array(steps + 1).keys()].slice(i === 0 ? 0 : 1).map((k) => pointOf(piece, k / steps).join(' '));
  }).flat().join('L')).join('');
  svg.append(create('path', {d}));
  return svg;
}

// The darkness of every pixel of an svg element.
async function inkOf(svg, height) {
  const copy = svg.cloneNode(true), style = create('style', {});
  style.textContent = HAIRLINES;
  copy.append(style);
  const image = new Image();
  image.src = 'data:image/svg+xml,' + encodeURIComponent(new XMLSerializer().serializeToString(copy));
  await image.decode();
  const canvas = new OffscreenCanvas(WIDTH, height), context = canvas.getContext('2d');
  context.drawImage(image, 0, 0, WIDTH, height);
  return context.getImageData(0, 0, WIDTH, height).data.filter((_, i) => i % 4 === 3);
}

// Counts pixels with ink in one picture and none near by in the other.
function unmatched(ink, other, height) {
  let count = 0, first = null;
  for (let y = 1; y + 1 < height; ++y)
    for (let x = 1; x + 1 < WIDTH; ++x) {
      if (ink[y * WIDTH + x] < INK) continue;
      let near = 0;
      for (let dy = -1; dy <= 1; ++dy)
        for (let dx = -1; dx <= 1; ++dx) near = Math.max(near, other[(y + dy) * WIDTH + x + dx]);
      if (near < TRACE && count++ === 0) first = [x, y];
    }
  return {count, first};
}

async function comparePictures(root, curves, say) {
  const {width, height} = root.getBoundingClientRect(), rows = Math.round(WIDTH * height / width);
  const its = await inkOf(root, rows), ours = await inkOf(curvesPicture(root, curves), rows);
  const missing = unmatched(its, ours, rows), added = unmatched(ours, its, rows);
  for (const [what, {count, first}] of [['missing', missing], ['added', added]])
    if (count > 0) say(`${count} pixels of the picture are ${what}, the first at ${first} of ${WIDTH} by ${rows}`);
  return its.filter((darkness) => darkness >= INK).length;
}
