// The states of a run as play shows them: cubic in time through the four around a moment, C1 like the motion itself.
// Straight lines between states would flatten a membrane that turns.

// Weights of the states k-1, k, k+1, k+2 at the fraction s of the way from k to k+1; h: the three intervals between them,
// where one beyond an end is 0.
function weights([before, own, after], s) {
  const left = s * (1 - s) ** 2, right = -(s * s) * (1 - s); // of the velocities at k and k+1, times the interval
  const a = (left * own) / (before + own), b = (right * own) / (own + after);
  const start = (1 + 2 * s) * (1 - s) ** 2, end = s * s * (3 - 2 * s);
  // The velocity at k is (x[k+1] - x[k-1]) / (before + own): one-sided at an end, where x[k-1] is x[k].
  return [-a, start - b, end + a, b];
}

const blend = (w, values) => values[0].map((_, i) => w.reduce((sum, weight, k) => sum + weight * values[k][i], 0));

function blendArrays(w, arrays) {
  const result = new Float32Array(arrays[0].length);
  for (let k = 0; k < w.length; k++)
    for (let i = 0, array = arrays[k], weight = w[k]; i < result.length; i++) result[i] += weight * array[i];
  return result;
}

// An axis has no sign.
function between(a, b, s) {
  if (!a || !b) return null;
  const sign = a.reduce((sum, value, i) => sum + value * b[i], 0) < 0 ? -1 : 1;
  return a.map((value, i) => (1 - s) * value + s * sign * b[i]);
}

export class Motion {
  constructor(model) {
    this.model = model;
  }

  // {frame, t, label, center, e1, L, position, normal, values(field)} of a computed state
  state(frame) {
    const {model} = this, {t, label, center, e1, L} = model.frames[frame], {position, normal} = model.shape(frame);
    return {frame, t, label, center, e1, L, position, normal, values: field => model.values(frame, field)};
  }

  // The same at `place`, counted in states: 2.5 is half-way from the third to the fourth.  What has names lies not in time.
  at(place) {
    const {model} = this, k = Math.floor(place), s = place - k, last = model.frames.length - 1;
    const frame = Math.round(place);
    if (model.frames[0].label || s === 0) return this.state(Math.min(frame, last));
    const around = [Math.max(k - 1, 0), k, k + 1, Math.min(k + 2, last)], frames = around.map(i => model.frames[i]);
    const w = weights([1, 2, 3].map(i => frames[i].t - frames[i - 1].t), s);
    const shapes = around.map(i => model.shape(i)), pair = [1 - s, s];
    return {
      frame,
      t: (1 - s) * frames[1].t + s * frames[2].t,
      center: blend(w, frames.map(({center}) => center)),
      e1: between(frames[1].e1, frames[2].e1, s),
      L: blend(pair, [frames[1].L, frames[2].L]),
      position: blendArrays(w, shapes.map(({position}) => position)),
      normal: blendArrays(pair, [shapes[1].normal, shapes[2].normal]),
      values: field => blendArrays(pair, [model.values(k, field), model.values(k + 1, field)]),
    };
  }
}
