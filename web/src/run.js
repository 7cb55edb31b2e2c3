// The page of a run.
import {capsule} from './capsule.js';
import {Curves} from './curves.js';
import {table} from './decode.js';
import {h, section} from './dom.js';
import {duration, format} from './format.js';
import {sortableTable} from './table.js';

const DEGREES = 180 / Math.PI;

const STATUS = {
  steady: 'steady state', end: 'end time reached', ruptured: 'ruptured', failed: 'computation failed', interrupted: 'interrupted',
};
const FLOWS = {
  simple_shear: 'simple shear', planar_hyperbolic: 'planar hyperbolic flow', uniaxial_extension: 'uniaxial extension',
  linear: 'linear flow', inflation: 'imposed inflation',
};

// Rows of the table of figures: key of summary.json, symbol, meaning, key of the physical value and its unit.
const FIGURES = [
  ['status', 'status', 'how the run ended'],
  ['t', 't', 'time at the end', 't_s', 's'],
  ['D12', 'D₁₂', 'Taylor deformation (L₁ − L₂)/(L₁ + L₂)'],
  ['beta', 'β', 'angle of e₁ from e_x, radians'],
  ['L1', 'L₁', 'longest axis of the ellipsoid of inertia', 'L1_m', 'm'],
  ['L2', 'L₂', 'axis across it in the plane of the flow', 'L2_m', 'm'],
  ['L3', 'L₃', 'axis along the vorticity', 'L3_m', 'm'],
  ['area_strain', '(S − S₀)/S₀', 'area strain'],
  ['d_max', 'd_max', 'largest damage'],
  ['Y_max', 'Y_max', 'largest energy release rate so far', 'Y_max_N_per_m', 'N/m'],
  ['t_c', 't_c', 'first damage', 't_c_s', 's'],
  ['t_l', 't_l', 'rupture: d reaches 1', 't_l_s', 's'],
  ['rupture.angle_to_vorticity_deg', '∠ vorticity', 'first rupture point from the vorticity axis, degrees'],
  ['rupture.angle_to_major_axis_deg', '∠ e₁', 'first rupture point from the major axis, degrees'],
  ['rupture.damaged_area_fraction', 'S(d > 0)/S₀', 'damaged part of the area at rupture'],
  ['volume_error', 'V/V₀ − 1', 'error of the volume'],
  ['volume_error_max', 'max |V/V₀ − 1|', 'largest error of the volume'],
  ['energy_error_max', 'max |ΔE|/E', 'largest error of the energy balance'],
  ['step_error_max', 'step error', 'largest error of a step, as time.tolerance bounds it'],
  ['wrinkle_amplitude_max', 'wrinkles', 'largest roughness on the scale of the mesh'],
  ['film_min', 'film/element', 'thinnest film between two parts of the membrane, in widths of the elements there'],
];
const COST = [
  ['wall_seconds', 'time taken', duration],
  ['threads', 'threads'],
  ['steps', 'steps'],
  ['rejected_steps', 'rejected steps'],
  ['unstable_steps', 'steps beyond the stability limit'],
  ['evaluations', 'velocity evaluations'],
  ['stage_evaluations', 'of these, inner stages by the coarse rule'],
  ['elements', 'elements'],
  ['nodes', 'nodes'],
];

const pick = (object, path) => path.split('.').reduce((value, key) => value?.[key], object);

function figureRow(summary, [key, symbol, meaning, physicalKey, unit]) {
  const value = pick(summary, key);
  if (value === undefined) return null;
  const text = typeof value === 'string' ? value : format(value);
  const physical = summary.physical?.[physicalKey];
  return h('tr', {},
    h('th', {scope: 'row'}, symbol),
    h('td', {class: 'number', 'data-key': key, title: value === null ? 'not reached' : String(value)}, text),
    h('td', {class: 'number'}, physical == null ? '' : `${format(physical, 4)} ${unit}`),
    h('td', {class: 'meaning'}, meaning));
}

// An imposed inflation keeps the sphere round and changes its volume: these say nothing there.
const NOT_OF_INFLATION = /^(D12|beta|L2|L3|volume_error.*|film_min|wrinkle_amplitude_max|rupture\.angle.*)$/;

function figures({summary, scene}) {
  if (!summary) return h('p', {class: 'note'}, 'summary.json is missing: the run has not come to its end.');
  const shown = FIGURES.filter(([key]) => scene.flow !== 'inflation' || !NOT_OF_INFLATION.test(key));
  const rows = shown.map(row => figureRow(summary, row)).filter(Boolean);
  return h('div', {class: 'scroll'}, h('table', {class: 'figures'}, h('tbody', {}, rows)));
}

function cost(summary) {
  if (!summary) return null;
  const rows = COST.filter(([key]) => summary[key] !== undefined).map(([key, label, show = format]) =>
    h('tr', {}, h('th', {scope: 'row'}, label), h('td', {class: 'number', 'data-key': key, title: String(summary[key])}, show(summary[key]))));
  return h('table', {class: 'figures'}, h('tbody', {}, rows));
}

function skipped(summary) {
  if (!summary?.skipped?.length) return h('p', {}, 'Nothing.');
  return h('ul', {}, summary.skipped.map(text => h('li', {}, text)));
}

function headline(data) {
  const {summary, scene} = data;
  const what = [
    scene.damage ? `${scene.elastic} with ${scene.damage} damage` : `${scene.elastic}, without damage`,
    scene.capillary_number == null ? FLOWS[scene.flow] : `${FLOWS[scene.flow]} at Ca = ${format(scene.capillary_number)}`,
  ];
  const status = summary?.status ?? 'unfinished';
  const outcome = status === 'ruptured' ? `ruptured at t = ${format(summary.t_l, 5)}` : STATUS[status] ?? 'not finished';
  return h('header', {},
    h('h1', {}, data.name, ' ', h('span', {class: `status ${status}`}, outcome)),
    h('p', {class: 'subtitle'}, what.join(' · ')));
}

// ---- curves ----

const sum = (a, b) => a.map((value, k) => value + b[k]);
const size = values => values.map(value => (value ? Math.abs(value) : null));

function flowCurves(curves, c, hasDamage) {
  curves.add('Taylor deformation D₁₂', [{label: 'D₁₂', values: c.D12}]);
  curves.add('inclination β, degrees', [{label: 'β', values: c.beta.map(beta => (beta == null ? null : beta * DEGREES))}]);
  curves.add('axes of the ellipsoid of inertia / a', [{label: 'L₁', values: c.L1}, {label: 'L₂', values: c.L2}, {label: 'L₃', values: c.L3}]);
  curves.add('area strain (S − S₀)/S₀', [{label: '(S − S₀)/S₀', values: c.area_strain}]);
  membraneCurves(curves, c, hasDamage);
}

function inflationCurves(curves, c, hasDamage) {
  curves.add('pressure difference p a/G_s', [{label: 'p', values: c.p}]);
  curves.add('imposed inflation α', [{label: 'α', values: c.alpha}]);
  curves.add('area strain (S − S₀)/S₀', [{label: '(S − S₀)/S₀', values: c.area_strain}]);
  membraneCurves(curves, c, hasDamage);
}

function membraneCurves(curves, c, hasDamage) {
  if (hasDamage) curves.add('largest damage d_max', [{label: 'd_max', values: c.d_max}]);
  curves.add('largest energy release rate Y_max/G_s', [{label: 'Y_max', values: c.Y_max}]);
  curves.add('principal tensions / G_s', [{label: 'largest T₁', values: c.T1_max}, {label: 'smallest T₂', values: c.T2_min}]);
  curves.add('energies / (G_s a²)', [
    {label: 'elastic', values: c.elastic_energy}, {label: 'dissipated', values: c.dissipated_energy},
    {label: 'sum', values: sum(c.elastic_energy, c.dissipated_energy)}]);
  const energy = {label: '|energy|', values: size(c.energy_error)}, volume = {label: '|volume|', values: size(c.volume_error)};
  curves.add('errors of the balances', c.alpha ? [energy] : [energy, volume], {log: true});
  curves.add('time step', [{label: 'step', values: c.step.map(step => step || null)}]);
}

function events(summary) {
  return [['t_c', 't_c'], ['t_l', 't_l']].filter(([key]) => summary?.[key] != null).map(([key, text]) => ({x: summary[key], text}));
}

function curvesOf(data, onpick) {
  const history = table(data.history), {column} = history;
  if (history.length < 2) return null;
  const curves = new Curves({label: 't', values: column.t}, {marks: events(data.summary), group: 'time', onpick});
  (data.scene.flow === 'inflation' ? inflationCurves : flowCurves)(curves, column, data.scene.damage !== null);
  return curves;
}

// ---- the capsule ----

// Where the membrane ruptured or is damaged most; then, for each criterion that looked on, the same, by its number.
function marksOf({summary, criteria}) {
  const own = summary?.rupture ? [{label: 'first rupture', X: summary.rupture.X}]
    : summary?.d_max_location ? [{label: 'largest d', X: summary.d_max_location.X}] : [];
  const others = criteriaOf(criteria).map(({X1, X2, X3, d_max}, k) => ({label: String(k + 1), X: [X1, X2, X3], d_max}));
  return [...own, ...others.filter(({d_max}) => d_max > 0)];
}

const criteriaOf = csv => (csv ? table(csv).rows : []);

const CRITERIA = [
  {key: 'number', label: '№', title: 'number of its mark on the capsule'},
  {key: 'criterion', label: 'criterion'},
  {key: 'law', label: 'law'},
  {key: 'status', label: 'status'},
  {key: 't_c', label: 't_c', title: 'first damage'},
  {key: 't_l', label: 't_l', title: 'rupture'},
  {key: 'd_max', label: 'd_max', title: 'largest damage'},
  {key: 'angle_to_vorticity_deg', label: '∠ vorticity', title: 'place of rupture, or of the largest damage, from the vorticity axis, degrees'},
  {key: 'angle_to_major_axis_deg', label: '∠ e₁', title: 'the same from the major axis, degrees'},
  {key: 'damaged_area_fraction', label: 'S(d > 0)/S₀', title: 'damaged part of the area'},
];

// Criteria of damage that looked on without acting on the membrane.
function criteria(csv) {
  const rows = criteriaOf(csv).map((row, k) => ({number: k + 1, ...row}));
  if (!rows.length) return null;
  return section('Criteria that looked on',
    h('p', {class: 'note'}, 'Each read this run without acting on it. Its place of rupture, or of largest damage, bears its number on the capsule.'),
    sortableTable(CRITERIA, rows));
}

export function runPage(data, start) {
  const viewer = capsule(data.surface, {...data.scene, marks: marksOf(data), start});
  const curves = curvesOf(data, viewer.showTime && (t => viewer.showTime(t)));
  if (curves && viewer.onframe) viewer.onframe(t => curves.showNow(t));
  return [
    headline(data),
    h('div', {class: 'top'},
      section('The capsule', viewer.element),
      section('Figures at the end', figures(data))),
    curves && section('Over time', h('p', {class: 'note'}, 'Lengths by a, time by 1/rate, tensions by G_s. Click to see the capsule at that time, drag to zoom, double-click to see all.'), curves.element),
    criteria(data.criteria),
    h('div', {class: 'ends'},
      section('Cost', cost(data.summary)),
      section('What was skipped', skipped(data.summary))),
    section('Scene and versions', h('details', {}, h('summary', {}, 'the scene with every default (resolved.yaml)'), h('pre', {id: 'scene'}, data.resolved))),
  ];
}
