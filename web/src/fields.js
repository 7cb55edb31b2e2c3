// What the capsule can be coloured by: each field gives its values at the drawing points of a frame.

// {id, label, signed, values(model, frame), bounds(frame)}: bounds, where they are known without the values.  A field whose arrays a run does not have is left out.
const FIELDS = [
  nodal('d', 'damage d'),
  nodal('Y', 'energy release rate Y / G_s'),
  nodal('T1', 'larger tension T₁ / G_s'),
  nodal('T2', 'smaller tension T₂ / G_s', true),
  {id: 'qn', label: 'normal load q·n', signed: true, needs: ['q'], values: normalLoad},
  {id: 'thickness', label: 'thickness h / h₀ (wall volume kept)', needs: [], values: thickness},
];

function nodal(id, label, signed = false) {
  return {
    id, label, signed, needs: [id],
    values: (model, frame) => model.surface.interpolate(model.array(frame, id)),
    bounds: frame => [frame[id].min, frame[id].max],
  };
}

function normalLoad(model, frame) {
  const q = model.surface.interpolate(model.array(frame, 'q'), 3), {normal} = model.shape(frame);
  return Float32Array.from({length: model.surface.nVertices},
    (_, v) => q[3 * v] * normal[3 * v] + q[3 * v + 1] * normal[3 * v + 1] + q[3 * v + 2] * normal[3 * v + 2]);
}

function thickness(model, frame) {
  const {area} = model.shape(frame), rest = model.surface.referenceArea;
  return area.map((value, v) => rest[v] / value);
}

export function fieldsOf(frames) {
  return FIELDS.filter(field => field.needs.every(name => frames.every(frame => frame[name])));
}
