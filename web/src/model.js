// The snapshots of a run, unpacked as they are asked for.
import {unpack, unpackIndices} from './decode.js';
import {fieldsOf} from './fields.js';
import {Surface, cutsFor} from './surface.js';

export class Model {
  // without: names of fields that say nothing in this run
  constructor(data, without = []) {
    const element = unpackIndices(data.element);
    this.data = data;
    this.frames = data.frames;
    this.surface = new Surface(element, unpack(data.X), cutsFor(element.length / 6));
    this.fields = fieldsOf(this.frames).filter(({id}) => !without.includes(id));
    this.kept = this.frames.map(() => ({}));
  }

  keep(frame, name, make) {
    return (this.kept[frame][name] ??= make());
  }

  array(frame, name) {
    return this.keep(frame, name, () => unpack(this.frames[frame][name]));
  }

  // {position, normal, area} at the drawing points
  shape(frame) {
    return this.keep(frame, 'shape', () => this.surface.place(this.array(frame, 'x')));
  }

  values(frame, field) {
    return this.keep(frame, `values of ${field.id}`, () => field.values(this, frame));
  }

  bounds(field, frame) {
    return this.keep(frame, `bounds of ${field.id}`, () => field.bounds?.(this.frames[frame]) ?? extent(this.values(frame, field)));
  }

  // Smallest and largest value of one frame, or of all (frame == null).
  range(field, frame) {
    const frames = frame == null ? this.frames.map((_, k) => k) : [frame];
    const bounds = frames.map(k => this.bounds(field, k));
    return widened([Math.min(...bounds.map(([low]) => low)), Math.max(...bounds.map(([, high]) => high))], field.signed);
  }

  // Largest distance from the centre at any time: what a picture must have room for.
  reach() {
    let reach = 1;
    this.frames.forEach(({center}, k) => {
      const x = this.array(k, 'x');
      for (let i = 0; i < x.length; i += 3)
        reach = Math.max(reach, Math.hypot(x[i] - center[0], x[i + 1] - center[1], x[i + 2] - center[2]));
    });
    return reach;
  }
}

function extent(values) {
  let low = Infinity, high = -Infinity;
  for (const value of values) if (value < low) low = value;
  for (const value of values) if (value > high) high = value;
  return [low, high];
}

// A colour bar needs some width: more than the round-off of 16 bits.  With a sign it is symmetric about 0.
function widened([low, high], signed) {
  if (!(low <= high)) return [0, 1];
  if (signed && low < 0) {
    const size = Math.max(-low, high);
    [low, high] = [-size, size];
  }
  const least = 1e-4 * Math.max(Math.abs(low), Math.abs(high));
  return high - low > least ? [low, high] : [low, low + (least || 1)];
}
