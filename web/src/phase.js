// The phase diagram: what becomes of the capsule over two varied keys, and the limits that a threshold study found.
import {DASHES, curveColor} from './colors.js';
import {h} from './dom.js';
import {format} from './format.js';
import {OUTCOMES, diagram, outcomeOf, path, s, spread} from './svg.js';

function legend(entries) {
  return h('ul', {class: 'legend'}, entries.map(([symbol, label]) => h('li', {}, s('svg', {viewBox: '-9 -9 18 18', width: 18, height: 18}, symbol), label)));
}

const outcomeLegend = used => legend(Object.entries(OUTCOMES).filter(([name]) => used.has(name)).map(([, {label, draw}]) => [draw([0, 0]), label]));

// One symbol for each case over axes x and y ({key, label}).
export function casesDiagram(rows, x, y) {
  const {svg, to} = diagram({label: x.label, range: spread(rows.map(row => row[x.key]))}, {label: y.label, range: spread(rows.map(row => row[y.key]))});
  const used = new Set();
  for (const row of rows) {
    if (typeof row[x.key] !== 'number' || typeof row[y.key] !== 'number') continue;
    const outcome = outcomeOf(row), symbol = OUTCOMES[outcome].draw(to(row[x.key], row[y.key]));
    used.add(outcome);
    symbol.append(s('title', {}, `${x.label} = ${format(row[x.key])}, ${y.label} = ${format(row[y.key])}: ${OUTCOMES[outcome].label}, d_max = ${format(row.d_max, 4)}`));
    svg.append(symbol);
  }
  return h('div', {class: 'chart'}, svg, outcomeLegend(used));
}

// Whether a limit does not depend on what tells the groups apart: it is drawn once.
function isShared(groups, x, key) {
  const line = group => JSON.stringify(group.rows.map(row => [row[x.key], row[key]]).sort((a, b) => a[0] - b[0]));
  return groups.every(group => line(group) === line(groups[0]));
}

const known = (rows, x, key) => rows.filter(row => typeof row[key] === 'number' && typeof row[x.key] === 'number').sort((a, b) => a[x.key] - b[x.key]);

function limit(to, known, x, key, stroke, dash, label) {
  const line = s('path', {d: path(known.map(row => to(row[x.key], row[key]))), fill: 'none', stroke, 'stroke-width': 2, 'stroke-dasharray': dash});
  const points = known.map(row => {
    const value = row[key], error = row[`${key}_error`] ?? 0, [cx, cy] = to(row[x.key], value);
    return s('g', {},
      s('path', {d: `M${cx} ${to(0, value - error)[1]}V${to(0, value + error)[1]}`, stroke, 'stroke-width': 1.5}),
      s('circle', {cx, cy, r: 3.5, fill: stroke}),
      s('title', {}, `${label} = ${format(value)} ± ${format(error, 2)} at ${x.label} = ${format(row[x.key])}`));
  });
  return [line, ...points];
}

// Limits over a varied key: targets are names of columns, with NAME_error beside them; one line for each target and
// group ({label, rows}).
export function limitsDiagram(groups, x, targets, yLabel) {
  const rows = groups.flatMap(group => group.rows), values = targets.flatMap(key => rows.map(row => row[key]));
  const {svg, to} = diagram({label: x.label, range: spread(rows.map(row => row[x.key]))}, {label: yLabel, range: spread([0, ...values])});
  const entries = [], ends = [];
  targets.forEach((key, k) => (isShared(groups, x, key) ? groups.slice(0, 1) : groups).forEach((group, g, shown) => {
    const stroke = curveColor(k), dash = DASHES[g % DASHES.length].join(' ');
    const label = group.label && shown.length > 1 ? `${key}, ${group.label}` : key;
    const rows = known(group.rows, x, key);
    svg.append(...limit(to, rows, x, key, stroke, dash, label));
    if (rows.length) ends.push({label, at: to(rows.at(-1)[x.key], rows.at(-1)[key])});
    entries.push([s('path', {d: 'M-9 0H9', stroke, 'stroke-width': 2.5, 'stroke-dasharray': dash}), label]);
  }));
  svg.append(...endLabels(ends));
  return h('div', {class: 'chart'}, svg, legend(entries));
}

// Names at the ends of lines: below the lowest, above the others.
function endLabels(ends) {
  const bottom = Math.max(...ends.map(({at}) => at[1]));
  return ends.map(({label, at: [x, y]}) => s('text', {x, y: y === bottom && ends.length > 1 ? y + 22 : y - 9, 'text-anchor': 'end'}, label));
}
