// Elements of SVG, and a frame with two axes.
import {format, ticks} from './format.js';

export function s(tag, properties = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (value != null && value !== false) element.setAttribute(name, value);
  }
  element.append(...children.flat().filter(child => child != null && child !== false));
  return element;
}

export const path = points => points.map(([x, y], k) => `${k ? 'L' : 'M'}${x.toFixed(2)} ${y.toFixed(2)}`).join('');

export const OUTCOMES = {
  whole: {label: 'no damage', draw: at => s('circle', {...center(at), r: 4.5, fill: 'var(--panel)', stroke: 'var(--whole)', 'stroke-width': 2})},
  damaged: {label: 'damaged', draw: at => s('circle', {...center(at), r: 5, fill: 'var(--damaged)'})},
  ruptured: {label: 'ruptured', draw: ([x, y]) => s('path', {d: `M${x - 4.5} ${y - 4.5}l9 9m-9 0l9 -9`, stroke: 'var(--ruptured)', 'stroke-width': 2.6, fill: 'none'})},
  failed: {label: 'failed or not run', draw: ([x, y]) => s('path', {d: `M${x} ${y - 5}l5 9h-10z`, fill: 'none', stroke: 'var(--muted)', 'stroke-width': 1.5})},
};

const center = ([x, y]) => ({cx: x, cy: y});

// What became of a case, from its row in a table of cases.
export function outcomeOf(row) {
  if (row.status === 'ruptured' || row.t_l != null) return 'ruptured';
  if (row.status === 'failed' || row.status === 'not run' || row.d_max == null) return 'failed';
  return row.d_max > 0 ? 'damaged' : 'whole';
}

const WIDTH = 560, HEIGHT = 360, LEFT = 62, RIGHT = 16, TOP = 12, BOTTOM = 46;

// {svg, to(x, y) -> [px, py], area}: an empty diagram of two ranges.
export function diagram(x, y) {
  const [right, bottom] = [WIDTH - RIGHT, HEIGHT - BOTTOM];
  const toX = value => LEFT + ((value - x.range[0]) / (x.range[1] - x.range[0])) * (right - LEFT);
  const toY = value => bottom - ((value - y.range[0]) / (y.range[1] - y.range[0])) * (bottom - TOP);
  const svg = s('svg', {viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: 'diagram', role: 'img'});
  const grid = s('g', {class: 'grid'});
  for (const value of ticks(x.range))
    grid.append(s('path', {d: `M${toX(value)} ${TOP}V${bottom}`}), s('text', {x: toX(value), y: bottom + 17, 'text-anchor': 'middle'}, format(value, 4)));
  for (const value of ticks(y.range))
    grid.append(s('path', {d: `M${LEFT} ${toY(value)}H${right}`}), s('text', {x: LEFT - 8, y: toY(value) + 4, 'text-anchor': 'end'}, format(value, 4)));
  svg.append(grid,
    s('text', {x: (LEFT + right) / 2, y: HEIGHT - 8, 'text-anchor': 'middle'}, x.label),
    s('text', {x: 14, y: (TOP + bottom) / 2, 'text-anchor': 'middle', transform: `rotate(-90 14 ${(TOP + bottom) / 2})`}, y.label));
  return {svg, to: (a, b) => [toX(a), toY(b)], area: {left: LEFT, right, top: TOP, bottom}};
}

// Smallest and largest of some numbers, with a margin.
export function spread(values, margin = 0.06) {
  const known = values.filter(value => typeof value === 'number'), low = Math.min(...known), high = Math.max(...known);
  const extra = (high - low || Math.abs(high) || 1) * margin;
  return [low - extra, high + extra];
}
