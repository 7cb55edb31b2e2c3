// Maps of the places of rupture, both of equal area: on the sphere at rest, seen along the y axis, and on the deformed
// capsule, by the angles to its own axes.
import {cssColor, curveColor} from './colors.js';
import {h} from './dom.js';
import {listed} from './format.js';
import {path, s} from './svg.js';

const SIZE = 300, MIDDLE = SIZE / 2, RADIUS = 118, DEGREES = 180 / Math.PI;

// Lambert's azimuthal projection: a circle at the polar angle theta; the rim is 90 degrees.
const radius = theta => RADIUS * Math.SQRT2 * Math.sin(theta / 2);

function disc(labels, arc) {
  const svg = s('svg', {viewBox: `0 0 ${SIZE} ${SIZE}`, class: 'map', role: 'img'});
  const circle = r => (arc ? s('path', {d: `M${arc.x + r} ${arc.y}A${r} ${r} 0 0 0 ${arc.x} ${arc.y - r}`}) : s('circle', {cx: MIDDLE, cy: MIDDLE, r}));
  const scale = arc ? arc.scale : 1;
  const grid = s('g', {class: 'grid', fill: 'none'}, [30, 60].map(angle => circle(scale * radius(angle / DEGREES))));
  grid.append(arc ? s('path', {d: `M${arc.x} ${arc.y}h${scale * RADIUS}M${arc.x} ${arc.y}v${-scale * RADIUS}`}) : s('path', {d: `M${MIDDLE - RADIUS} ${MIDDLE}h${2 * RADIUS}M${MIDDLE} ${MIDDLE - RADIUS}v${2 * RADIUS}`}));
  const rim = circle(scale * RADIUS);
  rim.setAttribute('class', 'rim');
  svg.append(grid, rim, ...labels.map(([x, y, text, anchor = 'middle']) => s('text', {x, y, 'text-anchor': anchor}, text)));
  return svg;
}

// A far point is shown by its image under inversion, to which a linear flow is blind.
export function onSphere([x, y, z]) {
  const length = Math.hypot(x, y, z), sign = y < 0 ? -1 : 1;
  const theta = Math.acos(Math.min(1, (sign * y) / length)), around = Math.atan2(sign * z, sign * x), r = radius(theta);
  return [MIDDLE + r * Math.cos(around), MIDDLE - r * Math.sin(around)];
}

const ARC = {x: 34, y: SIZE - 40, scale: (SIZE - 74) / RADIUS};

export function onCapsule(toVorticity, toMajor) {
  const theta = toVorticity / DEGREES, sine = Math.sin(theta), r = ARC.scale * radius(theta);
  const around = sine > 1e-9 ? Math.acos(Math.min(1, Math.cos(toMajor / DEGREES) / sine)) : 0;
  return [ARC.x + r * Math.cos(around), ARC.y - r * Math.sin(around)];
}

const placeOnSphere = ({X}) => X && onSphere(X);
const placeOnCapsule = ({toVorticity, toMajor}) => (toVorticity == null || toMajor == null ? null : onCapsule(toVorticity, toMajor));

// One text for the numbers of all sites that are drawn within a few pixels of each other.
function numbers(sites, place) {
  const clusters = [];
  for (const site of sites) {
    const at = site.number && place(site);
    if (!at) continue;
    const known = clusters.find(cluster => Math.hypot(cluster.at[0] - at[0], cluster.at[1] - at[1]) < 20);
    if (known) known.numbers.add(site.number);
    else clusters.push({at, numbers: new Set([site.number])});
  }
  return clusters.map(({at: [x, y], numbers}) => {
    const isRight = x > SIZE / 2 + 60;
    return s('text', {x: isRight ? x - 9 : x + 9, y: y - 7, 'text-anchor': isRight ? 'end' : 'start'}, listed(numbers));
  });
}

// sites: [{X, toVorticity, toMajor, title, number, group, shade}]; shade 0..1 colours by a number, else the group does.
export function sitesMap(sites, groups) {
  const sphere = disc([[MIDDLE, SIZE - 8, 'reference sphere, seen along y'], [MIDDLE + RADIUS + 6, MIDDLE + 4, 'x', 'start'], [MIDDLE, MIDDLE - RADIUS - 7, 'z']]);
  const capsule = disc([[ARC.x - 4, ARC.y + 16, 'vorticity axis', 'start'], [SIZE - 40, ARC.y + 16, 'e₁'], [ARC.x, 28, 'e₂'], [MIDDLE, SIZE - 8, 'deformed capsule, by its axes']], ARC);
  const dots = sites.map(site => {
    const fill = site.shade === undefined ? curveColor(site.group) : cssColor('viridis', site.shade);
    return [[sphere, placeOnSphere(site)], [capsule, placeOnCapsule(site)]]
      .filter(([, at]) => at).map(([svg, [x, y]]) => {
        const dot = s('g', {class: 'site'}, s('circle', {cx: x, cy: y, r: 5.5, fill, stroke: 'var(--panel)'}),
          s('title', {}, site.title));
        svg.append(dot);
        return dot;
      });
  });
  for (const [svg, at] of [[sphere, placeOnSphere], [capsule, placeOnCapsule]]) svg.append(...numbers(sites, at));
  const names = groups.length > 1 && h('ul', {class: 'legend'}, groups.map((name, k) =>
    h('li', {}, s('svg', {viewBox: '-9 -9 18 18', width: 18, height: 18}, s('circle', {r: 5.5, fill: curveColor(k)})), name)));
  return {
    element: h('div', {class: 'chart'}, h('div', {class: 'maps'}, sphere, capsule), names),
    choose: index => dots.forEach((pair, k) => pair.forEach(dot => dot.classList.toggle('chosen', k === index))),
  };
}
