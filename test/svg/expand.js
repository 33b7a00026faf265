// use elements, replaced by what they refer to, as the standard has it (SVG 2, section 5.6), as the browser lets nobody
// look inside of them. What it says of a use element is its box.

const SVG = 'http://www.w3.org/2000/svg', XLINK = 'http://www.w3.org/1999/xlink';

function create(name, attributes) {
  const element = document.createElementNS(SVG, name);
  for (const key in attributes) if (attributes[key] !== null) element.setAttribute(key, attributes[key]);
  return element;
}

// A copy of what `use` refers to; a symbol becomes an svg element. These two have their size from the use element.
function instanceOf(use, target) {
  if (target.localName !== 'symbol' && target.localName !== 'svg') return target.cloneNode(true);
  const sides = {width: '100%', height: '100%'}, svg = create('svg', target.localName === 'symbol' ? sides : {});
  for (const {name, value} of target.attributes) if (!name.startsWith('xmlns')) svg.setAttribute(name, value);
  for (const side in sides) if (use.hasAttribute(side)) svg.setAttribute(side, use.getAttribute(side));
  svg.append(...target.cloneNode(true).childNodes);
  return svg;
}

// Replaces all use elements in `root`, which is in the page, and tells `say` where the browser has another box of one.
function expandUses(root, say) {
  const originals = {}, boxes = [];
  for (const element of root.querySelectorAll('[id]'))
    if (!(element.id in originals)) originals[element.id] = element.cloneNode(true);
  const isDrawn = (element) => !element.closest('defs, symbol, clipPath, mask, marker, pattern');
  for (let use; (use = [...root.querySelectorAll('use')].find(isDrawn));) {
    const reference = use.getAttribute('href') || use.getAttributeNS(XLINK, 'href') || '';
    const target = originals[reference.slice(1)];
    const outer = create('g', {}), inner = create('g', {});
    for (const {name, value} of use.attributes)
      if (!/^(xmlns|xlink|href|x$|y$|width|height)/.test(name)) outer.setAttribute(name, value);
    inner.setAttribute('transform', `translate(${numberOf(use, 'x')} ${numberOf(use, 'y')})`);
    if (target) inner.append(instanceOf(use, target));
    outer.append(inner);
    if (use.getClientRects().length > 0) boxes.push({reference, before: use.getBBox(), outer});
    use.replaceWith(outer);
  }
  for (const {reference, before, outer} of boxes) {
    const after = outer.getBBox(), scale = Math.max(...['x', 'y', 'width', 'height'].map((k) => Math.abs(before[k])));
    for (const key of ['x', 'y', 'width', 'height'])
      if (!(Math.abs(before[key] - after[key]) <= SINGLE_PRECISION * scale))
        say(`use of ${reference}: the browser has ${key} ${before[key]}, not ${after[key]}`);
  }
}
