// A number in few characters that read back as the same.
const short = (x) => x !== 0 && (x < 1e-3 || x >= 1e6) ? x.toExponential() : String(x);

// Tables, by rows of cells; the first cell of a row is its head.
function fillTable(table, caption, columns, rows, isNow) {
  table.textContent = '';
  if (caption) table.createCaption().textContent = caption;
  const head = table.createTHead().insertRow();
  for (const column of columns) {
    const cell = head.appendChild(document.createElement('th'));
    cell.scope = 'col';
    cell.textContent = column;
  }
  const body = table.createTBody();
  rows.forEach((row, i) => {
    const line = body.insertRow();
    if (isNow && isNow(i)) line.className = 'now';
    row.forEach((value, k) => {
      const cell = line.appendChild(document.createElement(k === 0 ? 'th' : 'td'));
      if (k === 0) cell.scope = 'row';
      cell.textContent = value;
      if (String(value).length > 24) cell.className = 'long';
    });
  });
}

const COLUMNS =
    ['ε', 'method', 'regions', 'ratio', 'arcs', 'nodes', 'thickness', 'cut ms', 'build ms', 'arcs ms', 'sum ms'];

// The rows of compare for a curve, or of all of them where curve is -1; those of the tolerance shown are marked.
function showComparison(table, file, methods, names, curve, tolerance) {
  const rows = file.rows.filter((row) => row[0] === curve).sort((a, b) => a[2] - b[2] || a[1] - b[1]);
  const first = {};
  for (const row of rows) if (!(row[2] in first)) first[row[2]] = row[6];
  const ms = (value) => value === null ? '' : value.toPrecision(3);
  const cells = rows.map(([, m, e, cut, build, arcs, regions, count, nodes, thickness]) =>
      [short(file.eps[e]), names[methods[m]], regions, (regions / first[e]).toFixed(3), count, nodes,
       short(thickness), ms(cut), ms(build), ms(arcs), ms(cut + build + arcs)]);
  fillTable(table, '', COLUMNS, cells, (i) => rows[i][2] === tolerance);
}

function showAnswers(list, overlays) {
  list.textContent = '';
  for (const overlay of overlays) {
    list.appendChild(document.createElement('h3')).textContent = overlay.title;
    if (!overlay.rows.length) continue;
    const scroll = list.appendChild(document.createElement('div'));
    scroll.className = 'scroll';
    scroll.tabIndex = 0;
    scroll.setAttribute('role', 'region');
    scroll.setAttribute('aria-label', overlay.title);
    fillTable(scroll.appendChild(document.createElement('table')), '', overlay.columns, overlay.rows);
  }
}
