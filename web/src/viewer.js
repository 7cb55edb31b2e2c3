// The panel of the capsule: picture, colours, time, views.
import {MAPS, PLAIN, colorAt, cssGradient, cssVariable, onTheme} from './colors.js';
import {choice, h, toggle} from './dom.js';
import {format, listed, ticks} from './format.js';
import {Motion} from './motion.js';
import {Scene3d} from './scene3d.js';
import {Vector3} from 'three';

const TINTS = 256;
const LONGEST_PLAY = 8, LONGEST_STATE = 0.5; // seconds for all states, for each of few

const toLinear = c => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);

function tintsOf(map) {
  return Array.from({length: TINTS}, (_, k) => colorAt(map, k / (TINTS - 1)).map(toLinear));
}

// Labels that would lie over each other become one: [{at: {x, y}, labels}].
function clusters(placed) {
  const found = [];
  for (const {at, label} of placed) {
    const near = found.find(cluster => Math.hypot(cluster.at.x - at.x, cluster.at.y - at.y) < 16);
    if (near) near.labels.add(label);
    else found.push({at, labels: new Set([label])});
  }
  return found;
}

export class Viewer {
  // marks: [{label, X, frame}], points of the membrane by their reference position, in one frame or (undefined) all; flow: kind of the flow;
  // axis: {direction, label} of the flow, or null; start: wishes from the address ({frame, color, ...})
  constructor(model, {marks, flow, axis, start = {}}) {
    Object.assign(this, {model, flow, axis});
    this.motion = new Motion(model);
    this.marks = marks.map(mark => ({...mark, vertex: model.surface.nearest(mark.X)}));
    this.frame = Math.min(Number(start.frame ?? model.frames.length - 1) || 0, model.frames.length - 1);
    const {fields} = model, wanted = fields.find(field => field.id === start.color);
    this.field = wanted ?? (start.color === 'none' ? null : this.tellingField());
    this.map = MAPS[0];
    this.isSameRange = !model.frames[0].label; // cases differ in size
    this.listeners = [];
    this.build();
    this.open3d();
    this.look(start.view ?? 'oblique');
    this.show(this.frame);
  }

  // The first that is not the same everywhere: a capsule without damage is coloured by what strains it.
  tellingField() {
    const {model} = this;
    return model.fields.find(field => {
      const [low, high] = model.bounds(field, this.frame);
      return high > low;
    }) ?? model.fields[0];
  }

  onframe(listener) {
    this.listeners.push(listener);
    listener(this.model.frames[this.frame].t);
  }

  // ---- page ----

  build() {
    const {model} = this, last = model.frames.length - 1;
    this.picture = h('div', {class: 'picture'});
    this.labels = h('div', {class: 'labels'});
    this.picture.append(this.labels);
    this.readout = h('output', {class: 'readout'});
    this.time = h('output', {class: `time ${model.frames[0].label ? 'named' : ''}`, id: 'time'});
    this.slider = h('input', {type: 'range', id: 'slider', min: 0, max: last, step: 1, value: this.frame, 'aria-label': model.frames[0].label ? 'case' : 'time',
      oninput: () => (this.play(false), this.show(Number(this.slider.value)))});
    this.button = h('button', {class: 'play', 'aria-label': 'play', onclick: () => this.play(!this.isPlaying)}, '▶');
    this.bar = h('div', {class: 'bar'});
    const views = [['oblique', 'oblique'], ['shear', `along ${this.axis?.label ?? 'y'}`], ['e2', 'along e₂'], ['top', 'along z']];
    this.element = h('div', {class: 'viewer'},
      h('div', {class: 'tools'},
        choice('colour', [...model.fields.map(({id, label}) => [id, label]), ['none', 'shape only']], this.field?.id ?? 'none', id => {
          this.field = model.fields.find(field => field.id === id) ?? null;
          this.paint();
        }),
        choice('map', MAPS.map(name => [name, name]), this.map, name => (this.map = name, this.paint())),
        choice('range', [['all', 'all states'], ['this', 'this state']], this.isSameRange ? 'all' : 'this', which => (this.isSameRange = which === 'all', this.paint())),
        h('span', {class: 'buttons', role: 'group', 'aria-label': 'view'},
          views.map(([name, text]) => h('button', {onclick: () => this.look(name)}, text)))),
      this.picture,
      this.bar,
      h('div', {class: 'player'}, this.button, this.slider, this.time),
      h('div', {class: 'tools'},
        toggle('reference beside', true, on => this.showReference(on)),
        this.axis && toggle('axes', true, on => (this.scene.panes.forEach(pane => (pane.axes.visible = on)), this.scene.render())),
        toggle('elements', false, on => (this.scene.panes.forEach(pane => (pane.mesh.visible = on)), this.scene.render())),
        h('button', {onclick: () => this.save()}, 'save picture'),
        this.readout),
      h('p', {class: 'note'}, this.note()));
  }

  note() {
    const {frames, snapshots} = this.model.data;
    return `Drag to turn, scroll or pinch to zoom; both capsules are at one scale. Colours are values at the nodes, means over the elements around; d_max is over the integration points. ` +
      (frames.length > 1 && !frames[0].label ? 'Play fills in between the states; what stands still has been computed. ' : '') +
      (frames.length < snapshots ? `${frames.length} of ${snapshots} states are in this page.` : '');
  }

  open3d() {
    const {model} = this;
    this.scene = new Scene3d(this.picture, model.surface, model.reach(), () => this.placeLabels());
    this.scene.showReference = true;
    for (const pane of this.scene.panes) pane.addDots(this.marks);
    const {position, normal} = model.surface.reference;
    this.scene.reference.place(position, normal, [0, 0, 0]);
    this.picture.addEventListener('pointermove', event => this.hover(event));
    this.picture.addEventListener('pointerleave', () => (this.readout.textContent = ''));
    onTheme(() => {
      for (const pane of this.scene.panes) pane.outline.material.color.set(cssVariable('--outline'));
      for (const rod of this.scene.vorticity) rod.material.color.set(cssVariable('--vorticity'));
      this.scene.majorAxis.material.color.set(cssVariable('--major'));
      this.scene.draw();
    });
  }

  // ---- state ----

  show(frame) {
    this.display(this.motion.state(frame));
  }

  // A state of the run, or one that lies between two (its `frame` is the nearer one).
  display(state) {
    const {scene} = this, {frame, t, center, e1, L, position, normal} = state;
    this.frame = frame;
    this.state = state;
    for (const pane of scene.panes) pane.showDots(frame);
    scene.deformed.place(position, normal, center);
    const reach = 1.35;
    for (const rod of scene.vorticity) rod.visible = this.axis !== null;
    if (this.axis) {
      scene.vorticity[0].userData.turn(this.axis.direction, 2 * reach);
      scene.vorticity[1].userData.turn(this.axis.direction, L[2] + 2 * (reach - 1));
    }
    scene.majorAxis.visible = e1 !== null;
    if (e1) scene.majorAxis.userData.turn(e1, L[0] + 2 * (reach - 1));
    this.slider.value = frame;
    this.time.textContent = this.title();
    this.slider.setAttribute('aria-valuetext', this.title());
    this.paint();
    for (const listener of this.listeners) listener(t);
  }

  // A state is known by its name or by its time.
  title() {
    const {t, label} = this.state;
    return label ?? `t = ${format(t, this.isPlaying ? 3 : 5)}`;
  }

  showReference(on) {
    this.scene.showReference = on;
    this.picture.classList.toggle('alone', !on);
    this.scene.draw();
  }

  showTime(t) {
    const distance = this.model.frames.map(frame => Math.abs(frame.t - t));
    this.show(distance.indexOf(Math.min(...distance)));
  }

  play(on) {
    if (!on && !this.isPlaying) return;
    this.isPlaying = on;
    this.button.textContent = on ? '❚❚' : '▶';
    this.button.setAttribute('aria-label', on ? 'pause' : 'play');
    if (!on) return this.show(this.frame); // what stands still has been computed
    const last = this.model.frames.length - 1, from = this.frame === last ? 0 : this.frame;
    const rate = Math.max(last / LONGEST_PLAY, 1 / LONGEST_STATE);
    const begin = performance.now();
    const next = now => {
      if (!this.isPlaying) return;
      const place = from + (rate * Math.max(0, now - begin)) / 1000;
      if (place >= last) return (this.frame = last, this.play(false));
      this.display(this.motion.at(place));
      requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  }

  look(name) {
    const side = this.marks[0]?.X[1] > 0.1 ? 1 : -1, e2 = this.model.frames[this.frame].e2;
    const from = {oblique: [0.55 * -side, side, 0.5], shear: this.axis ? this.axis.direction.map(c => (c ? -c : 0)) : [0, -1, 0], e2: e2 ?? [0, 0, 1], top: [0, -1e-4, 1]};
    this.scene.lookFrom(from[name] ?? from.oblique);
  }

  // ---- colours ----

  tints() {
    return tintsOf(this.field?.signed && this.limits[0] < 0 ? 'signed' : this.map);
  }

  paint() {
    const {model, field} = this, n = model.surface.nVertices, colors = new Float32Array(3 * n);
    const values = field && this.state.values(field);
    this.limits = field && model.range(field, this.isSameRange ? null : this.frame);
    const tints = field && this.tints(), plain = PLAIN.map(toLinear);
    for (let v = 0; v < n; v++) {
      const fraction = field ? (values[v] - this.limits[0]) / (this.limits[1] - this.limits[0]) : NaN;
      colors.set(Number.isNaN(fraction) ? plain : tints[Math.round((TINTS - 1) * Math.min(Math.max(fraction, 0), 1))], 3 * v);
    }
    for (const pane of this.scene.panes) pane.paint(colors);
    this.drawBar();
    this.scene.draw();
  }

  drawBar() {
    this.bar.replaceChildren();
    if (!this.field) return;
    const [low, high] = this.limits, map = this.field.signed && low < 0 ? 'signed' : this.map;
    this.bar.append(
      h('span', {class: 'label'}, this.field.label),
      h('div', {class: 'gradient', style: `background: ${cssGradient(map)}`}),
      h('div', {class: 'ticks'}, ticks(this.limits).map(value =>
        h('span', {style: `left: ${(100 * (value - low)) / (high - low)}%`}, format(value, 4)))));
  }

  // ---- labels over the picture ----

  placeLabels() {
    const {scene} = this;
    if (!scene || !this.state) return;
    this.labels.replaceChildren();
    const put = (pane, point, text, kind) => {
      const place = scene.project(pane, point);
      if (place) this.labels.append(h('span', {class: kind, style: `left: ${place.x}px; top: ${place.y}px`}, text));
    };
    for (const [pane, box] of scene.layout()) {
      const title = pane === scene.reference ? 'reference shape' : this.title();
      this.labels.append(h('span', {class: 'title', style: `left: ${box.x + box.width / 2}px; top: ${box.y + box.height - 24}px`}, title));
    }
    const {e1, L} = this.state;
    const axis = this.axis && new Vector3(...this.axis.direction);
    const isAcross = axis && Math.abs(axis.dot(scene.camera.position.clone().normalize())) < 0.95; // else seen end-on
    if (scene.reference.axes.visible && isAcross) {
      put(scene.deformed, axis.clone().multiplyScalar(-(L[2] / 2 + 0.48)), this.axis.label, 'axis vorticity');
      put(scene.reference, axis.clone().multiplyScalar(-1.5), this.axis.label, 'axis vorticity');
    }
    if (scene.reference.axes.visible && e1) put(scene.deformed, new Vector3(...e1).multiplyScalar(L[0] / 2 + 0.45), 'e₁', 'axis major');
    this.placeMarks();
    this.placeTriad();
  }

  placeMarks() {
    const {scene} = this, shown = this.marks.filter(({frame}) => frame === undefined || frame === this.frame);
    for (const pane of scene.panes) {
      const placed = shown.map(({vertex, label}) => ({label, at: scene.project(pane, pane.point(vertex))}));
      for (const {at, labels} of clusters(placed.filter(({at}) => at)))
        this.labels.append(h('span', {class: 'mark', style: `left: ${at.x}px; top: ${at.y}px`}, listed(labels)));
    }
  }

  // Directions of the flow in the corner.
  placeTriad() {
    const size = 30, corner = {x: 80, y: this.picture.clientHeight - 50};
    const names = this.flow === 'simple_shear' ? ['x (flow)', 'y', 'z (gradient)'] : ['x', 'y', 'z'];
    const svg = [0, 1, 2].map(k => {
      const p = new Vector3(...[0, 1, 2].map(c => Number(c === k))).applyQuaternion(this.scene.camera.quaternion.clone().invert());
      const x = size * p.x, y = -size * p.y, length = Math.hypot(x, y);
      const label = length > 6 ? `<text x="${x + (10 * x) / length}" y="${y + (12 * y) / length + 4}" text-anchor="${x > 8 ? 'start' : x < -8 ? 'end' : 'middle'}">${names[k]}</text>` : '';
      return `<path d="M0 0L${x} ${y}"/>${label}`;
    });
    const triad = h('div', {class: 'triad', style: `left: ${corner.x}px; top: ${corner.y}px`});
    triad.innerHTML = `<svg overflow="visible" width="1" height="1">${svg.join('')}</svg>`;
    this.labels.append(triad);
  }

  hover(event) {
    if (event.buttons || !this.field) return;
    const box = this.picture.getBoundingClientRect();
    const found = this.scene.pick(event.clientX - box.left, event.clientY - box.top);
    this.readout.textContent = found ? `${this.field.label.split(' (')[0]} = ${format(this.state.values(this.field)[found.vertex], 4)}` : '';
  }

  save() {
    this.scene.render();
    const link = h('a', {href: this.scene.canvas.toDataURL('image/png'), download: `capsule-${this.title().replaceAll(' ', '')}.png`});
    link.click();
  }
}
