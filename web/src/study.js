// The page of a study.
import {capsule} from './capsule.js';
import {Curves} from './curves.js';
import {table} from './decode.js';
import {choice, h, section} from './dom.js';
import {duration, format} from './format.js';
import {casesDiagram, limitsDiagram} from './phase.js';
import {sitesMap} from './sites.js';
import {outcomeOf} from './svg.js';
import {sortableTable} from './table.js';

const KINDS = {sweep: 'sweep', threshold: 'search for thresholds', compare: 'comparison of criteria'};
const CAPILLARY = 'flow.capillary_number';
const NAMES = {[CAPILLARY]: 'Ca', 'capsule.mesh.subdivisions': 'subdivisions'};
const LABELS = {
  D12: 'Taylor deformation D₁₂', beta: 'inclination β, radians', area_strain: 'area strain', d_max: 'largest damage d_max',
  Y_max: 'largest energy release rate Y_max/G_s', t_c: 'time of first damage t_c', t_l: 'time of rupture t_l',
  angle_to_vorticity_deg: 'angle of the site to the vorticity axis, degrees',
  angle_to_major_axis_deg: 'angle of the site to the major axis, degrees', damaged_area_fraction: 'damaged part of the area',
};
const FIRST = ['d_max', 'angle_to_major_axis_deg', 'D12', 'Y_max'];
const MOST_LINES = 12;

const shortName = key => NAMES[key] ?? key.split('.').at(-1);
const isNumber = value => typeof value === 'number';

// A varied key is the only kind of column with a dot in its name, but for the few keys that stand at the top of a scene.
const isAxis = name => name.includes('.') || ['accuracy', 'symmetry', 'name'].includes(name);

class Results {
  constructor(data) {
    const {names, rows, column} = table(data.table);
    Object.assign(this, {names, rows, column});
    const first = names.findIndex(name => !isAxis(name));
    this.axes = names.slice(0, first < 0 ? names.length : first).map(key => ({key, label: shortName(key)}));
    this.numericAxes = this.axes.filter(({key}) => column[key].every(isNumber) && this.valuesOf(key).length > 1)
      .sort((a, b) => (b.key === CAPILLARY) - (a.key === CAPILLARY)); // first what is asked for first
    this.figures = names.slice(this.axes.length).filter(name => column[name].some(isNumber) && !/_[123]$/.test(name) && name !== 'case');
    this.hasCases = names.includes('status');
  }

  valuesOf(name) {
    return [...new Set(this.column[name])].sort((a, b) => a - b);
  }

  // Rows that agree in all that is varied but `without`: [{label, rows}].
  groups(...without) {
    const others = this.axes.filter(({key}) => !without.includes(key)), groups = new Map();
    const extra = ['criterion', 'mode'].filter(name => this.names.includes(name) && new Set(this.column[name]).size > 1);
    for (const row of this.rows) {
      const label = [...extra.map(name => row[name]), ...others.map(({key, label}) => `${label} = ${isNumber(row[key]) ? format(row[key]) : row[key]}`)].join(', ');
      if (!groups.has(label)) groups.set(label, []);
      groups.get(label).push(row);
    }
    return [...groups].map(([label, rows]) => ({label, rows}));
  }
}

// ---- curves ----

function curvesOver(results, x, figure) {
  const values = results.valuesOf(x.key), groups = results.groups(x.key);
  const curves = new Curves({label: x.label, values}, {height: 320});
  const lines = groups.slice(0, MOST_LINES).map(({label, rows}) => {
    const at = values.map(value => rows.find(row => row[x.key] === value));
    return {
      label: label || LABELS[figure] || figure, points: true,
      values: at.map(row => row?.[figure] ?? null), crosses: at.map(row => row !== undefined && outcomeOf(row) === 'ruptured'),
    };
  });
  curves.add(LABELS[figure] ?? figure, lines);
  const note = groups.length > MOST_LINES ? `The first ${MOST_LINES} of ${groups.length} lines; all are in the table. ` : '';
  return h('div', {class: 'wide'}, curves.element, h('p', {class: 'note'}, `${note}A cross is a case that ruptured.`));
}

// A chart with choices above it: it is drawn anew when one changes.
function chosen(choices, draw) {
  const host = h('div'), state = Object.fromEntries(choices.map(([name, , , selected]) => [name, selected]));
  const show = () => host.replaceChildren(draw(state));
  show();
  return [h('div', {class: 'tools'}, choices.map(([name, label, options, selected]) =>
    choice(label, options, selected, value => (state[name] = value, show())))), host];
}

function curvesSection(results) {
  const {numericAxes, figures} = results;
  if (!results.hasCases || !numericAxes.length || !figures.length) return null;
  const first = FIRST.find(name => figures.includes(name)) ?? figures[0];
  const axis = key => numericAxes.find(one => one.key === key);
  return section('Over what is varied', ...chosen([
    ['figure', 'figure', figures.map(name => [name, LABELS[name] ?? name]), first],
    ['x', 'over', numericAxes.map(({key, label}) => [key, label]), numericAxes[0].key],
  ], ({figure, x}) => curvesOver(results, axis(x), figure)));
}

// ---- phase diagram ----

function phaseSection(results, data) {
  const {numericAxes} = results, options = numericAxes.map(({key, label}) => [key, label]);
  const axis = key => numericAxes.find(one => one.key === key);
  if (data.summary.study === 'threshold') {
    const targets = results.names.filter(name => results.names.includes(`${name}_low`)); // each is a column with its bracket
    if (!numericAxes.length || !targets.length) return null;
    const most = numericAxes.reduce((a, b) => (results.valuesOf(b.key).length > results.valuesOf(a.key).length ? b : a));
    return section('Phase diagram', ...chosen([['x', 'over', options, most.key]],
      ({x}) => limitsDiagram(results.groups(x), axis(x), targets, targets.every(name => name.startsWith('Ca')) ? 'Ca' : 'threshold')),
    h('p', {class: 'note'}, 'Bars are the errors of the values, where they are larger than the dots.'));
  }
  if (numericAxes.length < 2 || results.names.includes('criterion')) return null;
  return section('Phase diagram', ...chosen([['x', 'across', options, options[0][0]], ['y', 'up', options, options[1][0]]],
    ({x, y}) => casesDiagram(results.rows, axis(x), axis(y))));
}

// ---- map of sites ----

const vector = (row, name) => (isNumber(row[`${name}_1`]) ? [1, 2, 3].map(k => row[`${name}_${k}`]) : null);

function sitesOf(results) {
  const isCompared = results.names.includes('criterion'), scale = results.numericAxes[0];
  const groups = isCompared ? [...new Set(results.column.criterion)] : [];
  const range = scale && [Math.min(...results.column[scale.key]), Math.max(...results.column[scale.key])];
  const sites = results.rows.map((row, index) => ({
    index, X: vector(row, 'rupture_X') ?? vector(row, 'X'), toVorticity: row.angle_to_vorticity_deg, toMajor: row.angle_to_major_axis_deg,
    title: [row.criterion, row.mode, row.case, row.status].filter(Boolean).join(', '),
    number: isCompared ? groups.indexOf(row.criterion) + 1 : undefined, group: isCompared ? groups.indexOf(row.criterion) : 0,
    shade: isCompared || !scale ? undefined : (row[scale.key] - range[0]) / (range[1] - range[0]),
  })).filter(({X}) => X !== null);
  return {sites, groups: groups.map((name, k) => `${k + 1} ${name}`), scale, range};
}

function sitesSection({sites, groups, scale, range}, map) {
  if (!sites.length) return null;
  const colours = !groups.length && scale ? ` Colours run from ${scale.label} = ${format(range[0])} (dark) to ${format(range[1])} (bright).` : '';
  return section('Where it ruptures', map.element,
    h('p', {class: 'note'}, `Equal areas on the maps are equal areas on the sphere; circles at 30° and 60° from the axis. Points on the far side are shown by their images under the symmetry of a linear flow. Press a row of the table to find it here.${colours}`));
}

// ---- page ----

function headline(data) {
  const {summary} = data, counts = [`${summary.cases} cases`];
  if (summary.failed) counts.push(`${summary.failed} failed`);
  if (summary.mode) counts.push(summary.mode);
  if (summary.runs_saved > 0) counts.push(`${summary.runs_saved} runs saved against plain halving`);
  return h('header', {},
    h('h1', {}, summary.name, ' ', h('span', {class: `status ${summary.status === 'done' ? 'end' : 'interrupted'}`}, summary.status)),
    h('p', {class: 'subtitle'}, [KINDS[summary.study] ?? summary.study, ...counts].join(' · ')));
}

function tableSection(results, onselect) {
  const columns = results.names.map(key => ({key, label: results.axes.some(axis => axis.key === key) ? shortName(key) : key, title: LABELS[key] ?? key}))
    .filter(({key}) => !/_[123]$/.test(key) && results.column[key].some(value => value !== null));
  return section('Table',
    h('p', {class: 'note'}, 'The same as table.csv, but for coordinates. Press a head to sort. `capsella report cases/NAME` makes the page of a case.'),
    sortableTable(columns, results.rows, onselect));
}

function costSection(summary) {
  const own = summary.this_process;
  if (!own) return null;
  return section('Cost', h('p', {}, `${duration(own.wall_seconds)} with ${own.jobs} ${own.jobs === 1 ? 'case at a time' : 'cases side by side'}; ${own.cases_taken_over} cases taken over, ${summary.shared_requests} requests shared.`));
}

// ---- the capsule, case by case ----

// In the order of the table; cases that are in no row (runs of a search) by name, after them.
function inOrder(surface, results) {
  const order = name => (results.column.case ?? []).indexOf(name) >>> 0; // -1 is the last
  const frames = [...surface.frames].sort((a, b) => order(a.label) - order(b.label) || a.label.localeCompare(b.label, 'en', {numeric: true}));
  return {...surface, frames};
}

// The sites of compared criteria are marked in every case, by their numbers; those of other cases in their own.
function marksOf(results, {sites}, frames) {
  return sites.map(({index, X, number}) => {
    const frame = frames.findIndex(({label}) => label === results.rows[index].case);
    return number ? {X, label: String(number)} : {X, label: 'first rupture', frame};
  });
}

function viewerOf(data, results, found, start) {
  if (!data.surface) return null;
  const surface = inOrder(data.surface, results), flow = data.gradient[2] === 1 && data.gradient[0] === 0 ? 'simple_shear' : undefined;
  return capsule(surface, {flow, gradient: data.gradient, marks: marksOf(results, found, surface.frames), start: {frame: 0, ...start}});
}

export function studyPage(data, start) {
  const results = new Results(data), found = sitesOf(results), map = sitesMap(found.sites, found.groups);
  const viewer = viewerOf(data, results, found, start);
  const select = row => {
    map.choose(found.sites.findIndex(({index}) => results.rows[index] === row));
    const frame = viewer?.model?.frames.findIndex(({label}) => label === row.case);
    if (frame >= 0) viewer.show(frame);
  };
  return [
    headline(data),
    h('div', {class: 'charts'}, curvesSection(results), phaseSection(results, data), sitesSection(found, map),
      viewer && section('The capsule at the end of each case', viewer.element)),
    tableSection(results, select),
    costSection(data.summary),
    data.scene && section('The scene of the study', h('details', {}, h('summary', {}, 'scene.yaml'), h('pre', {}, data.scene))),
  ];
}
