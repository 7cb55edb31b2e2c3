// The panel of the capsule, or why there is none.
import {h} from './dom.js';
import {Model} from './model.js';
import {Viewer} from './viewer.js';

// The axis that L3 and e1 refer to: a flow without vorticity has its intermediate axis of strain in its place.
function axisOf(surface, gradient) {
  if (!surface.vorticity) return null;
  const rotates = [[0, 1], [1, 2], [2, 0]].some(([i, j]) => gradient[3 * i + j] !== gradient[3 * j + i]);
  return {direction: surface.vorticity, label: rotates ? 'vorticity' : 'middle axis'};
}

// surface: as in the data, or null; flow: its kind, where it is known; damage: null where there is none.
export function capsule(surface, {flow, gradient, damage, marks, start}) {
  if (!surface) return {element: h('p', {class: 'note'}, 'There is no whole snapshot to draw.')};
  try {
    return new Viewer(new Model(surface, damage === null ? ['d'] : []), {marks, flow, axis: axisOf(surface, gradient), start});
  } catch (error) {
    if (!/webgl/i.test(error.message)) throw error;
    return {element: h('p', {class: 'note'}, 'This browser has no WebGL, which the picture of the capsule needs.')};
  }
}
