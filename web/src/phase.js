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

// Limits over a varied key: targets [{key, label}], one line for each and each group ({label, rows}).
export function limitsDiagram(groups, x, targets, yLabel) {
  const rows = groups.flatMap(group => group.rows);
  const values = targets.flatMap(({key}) => rows.map(row => row[key]));
  const {svg, to} = diagram({label: x.label, range: spread(rows.map(row => row[x.key]))}, {label: yLabel, range: spread([0, ...values])});
  const entries = [];
  groups.forEach((group, g) => targets.forEach(({key, label}, k) => {
    const known = group.rows.filter(row => typeof row[key] === 'number' && typeof row[x.key] === 'number').sort((a, b) => a[x.key] - b[x.key]);
    if (!known.length) return;
    const stroke = curveColor(k), dash = (DASHES[g % DASHES.length] ?? []).join(' ');
    svg.append(s('path', {d: path(known.map(row => to(row[x.key], row[key]))), fill: 'none', stroke, 'stroke-width': 2, 'stroke-dasharray': dash}));
    for (const row of known) {
      const [cx, cy] = to(row[x.key], row[key]);
      svg.append(s('circle', {cx, cy, r: 3.5, fill: stroke}, s('title', {}, `${label} = ${format(row[key])} at ${x.label} = ${format(row[x.key])}${group.label ? `, ${group.label}` : ''}`)));
    }
    entries.push([s('path', {d: 'M-9 0H9', stroke, 'stroke-width': 2.5, 'stroke-dasharray': dash}), group.label ? `${label}, ${group.label}` : label]);
  }));
  return h('div', {class: 'chart'}, svg, legend(entries));
}
