// Curves with hover: thin dressing of uPlot.
import uPlot from 'uplot';
import {DASHES, cssVariable, curveColors, onTheme} from './colors.js';
import {h, onResize} from './dom.js';
import {format} from './format.js';

const HEIGHT = 210;

function axis(label) {
  return {
    label, stroke: cssVariable('--text'), labelSize: 20, labelGap: 0, size: label === undefined ? 54 : 34,
    font: '12px system-ui, sans-serif', labelFont: '12px system-ui, sans-serif',
    grid: {stroke: cssVariable('--grid'), width: 1}, ticks: {stroke: cssVariable('--grid'), width: 1, size: 4},
    values: (_, values) => values.map(value => (value == null ? '' : format(value, 4))),
  };
}

// Curves that differ from a constant by round-off only are drawn flat.
function linearRange(_, low, high) {
  if (low == null) return [0, 1];
  return high - low > 1e-9 ? uPlot.rangeNum(low, high, 0.1, true) : [low - 1, high + 1];
}

// Powers of ten, so many that their numbers do not touch.
function powers(_, __, low, high) {
  const first = Math.ceil(Math.log10(low) - 1e-9), last = Math.floor(Math.log10(high) + 1e-9), every = Math.ceil((last - first + 1) / 6);
  return Array.from({length: Math.max(0, last - first + 1)}, (_, k) => first + k).filter(n => n % every === 0).map(n => 10 ** n);
}

// Upright lines at chosen x, each {x, text}.
function uprights(plot, lines, color, dash) {
  const {ctx, bbox} = plot, ratio = devicePixelRatio;
  ctx.save();
  ctx.strokeStyle = ctx.fillStyle = color;
  ctx.lineWidth = ratio;
  ctx.font = `${11 * ratio}px system-ui, sans-serif`;
  ctx.setLineDash(dash.map(length => length * ratio));
  for (const {x, text} of lines) {
    const left = plot.valToPos(x, 'x', true);
    if (!(left >= bbox.left - 1 && left <= bbox.left + bbox.width + 1)) continue;
    ctx.beginPath();
    ctx.moveTo(left, bbox.top);
    ctx.lineTo(left, bbox.top + bbox.height);
    ctx.stroke();
    const isRoom = left + 22 * ratio < bbox.left + bbox.width;
    ctx.textAlign = isRoom ? 'left' : 'right';
    if (text) ctx.fillText(text, left + (isRoom ? 4 : -4) * ratio, bbox.top + 11 * ratio);
  }
  ctx.restore();
}

// Crosses on the points of a line where `crosses` is true.
function crossOut(plot, lines, colors) {
  const {ctx} = plot, arm = 5 * devicePixelRatio;
  ctx.save();
  ctx.lineWidth = 2 * devicePixelRatio;
  lines.forEach(({crosses, values}, k) => {
    ctx.strokeStyle = colors[k % colors.length];
    crosses?.forEach((isCrossed, i) => {
      if (!isCrossed || values[i] == null) return;
      const x = plot.valToPos(plot.data[0][i], 'x', true), y = plot.valToPos(values[i], 'y', true);
      ctx.beginPath();
      for (const side of [-1, 1]) {
        ctx.moveTo(x - arm, y - side * arm);
        ctx.lineTo(x + arm, y + side * arm);
      }
      ctx.stroke();
    });
  });
  ctx.restore();
}

export class Curves {
  // x: {label, values}; marks: [{x, text}] drawn in every plot; onpick(x): the user chose a place on the axis.
  constructor(x, {marks = [], group, onpick, height = HEIGHT} = {}) {
    Object.assign(this, {x, marks, group, onpick, height, plots: [], wanted: []});
    this.element = h('div', {class: 'curves'});
    onResize(this.element, () => this.resize());
    onTheme(() => this.redraw());
  }

  // lines: [{label, values, points, crosses}] over x: points marks each value, crosses [true where crossed out]; log: logarithmic axis of values
  add(title, lines, {log = false} = {}) {
    const host = h('figure', {class: 'curve'}, h('figcaption', {}, title));
    this.element.append(host);
    this.wanted.push({title, lines, log, host});
  }

  width(host) {
    return Math.max(180, host.clientWidth - 2);
  }

  redraw() {
    if (!this.element.isConnected) return;
    for (const plot of this.plots) plot.destroy();
    this.plots = this.wanted.map(wanted => this.draw(wanted));
    if (this.now !== undefined) this.showNow(this.now);
  }

  draw({lines, log, host}) {
    const colors = curveColors();
    const options = {
      width: this.width(host), height: this.height,
      scales: {x: {time: false}, y: log ? {distr: 3} : {range: linearRange}},
      cursor: {sync: this.group && {key: this.group, setSeries: false}, drag: {x: true, y: false}, points: {size: 6}},
      legend: {live: true},
      axes: [axis(this.x.label), {...axis(), ...(log && {splits: powers, filter: (_, splits) => splits})}],
      series: [
        {label: this.x.label, value: (_, value) => format(value, 5)},
        ...lines.map(({label, points}, k) => ({
          label, stroke: colors[k % colors.length], width: 1.8, dash: DASHES[k % DASHES.length],
          points: {show: points === true, size: 7, fill: colors[k % colors.length]}, spanGaps: true,
          value: (_, value) => format(value, 5),
        })),
      ],
      hooks: {
        draw: [plot => {
          crossOut(plot, lines, colors);
          uprights(plot, this.marks, cssVariable('--muted'), [3, 3]);
          if (this.now !== undefined) uprights(plot, [{x: this.now}], cssVariable('--accent'), []);
        }],
        ready: [plot => this.onpick && plot.over.addEventListener('click', () => this.onpick(plot.posToVal(plot.cursor.left, 'x')))],
      },
    };
    return new uPlot(options, [this.x.values, ...lines.map(line => line.values)], host);
  }

  resize() {
    if (!this.plots.length) return this.redraw();
    this.plots.forEach((plot, k) => {
      const width = this.width(this.wanted[k].host);
      if (width !== plot.width) plot.setSize({width, height: this.height});
    });
  }

  // Marks the place on the axis that is shown elsewhere on the page.
  showNow(x) {
    this.now = x;
    for (const plot of this.plots) plot.redraw(false, false);
  }
}
