#include "run/nodal_fields.h"

#include "base/array.h"

Status nodal_fields_new(NodalFields *fields, const Simulation *s, Error *error) {
  Status status = STATUS_OK;
  const size_t nodes = (size_t)s->mesh.n_nodes, points = (size_t)membrane_points(s->membrane);
  *fields = (NodalFields){0};
  TRY(ARRAY_NEW(&fields->d, nodes, error));
  TRY(ARRAY_NEW(&fields->Y, nodes, error));
  TRY(ARRAY_NEW(&fields->T1, nodes, error));
  TRY(ARRAY_NEW(&fields->T2, nodes, error));
  TRY(ARRAY_NEW(&fields->points, 2 * points, error));
cleanup:
  if (status != STATUS_OK) nodal_fields_free(fields);
  return status;
}

void nodal_fields_free(NodalFields *fields) {
  array_free(fields->d);
  array_free(fields->Y);
  array_free(fields->T1);
  array_free(fields->T2);
  array_free(fields->points);
  *fields = (NodalFields){0};
}

void nodal_fields_measure(NodalFields *fields, const Simulation *s) {
  const double G = s->material.shear_modulus;
  const MembranePoints view = membrane_points_view(s->membrane);
  double *T1 = fields->points, *T2 = fields->points + membrane_points(s->membrane);
  membrane_principal_tensions(s->membrane, T1, T2);
  membrane_nodal_field(s->membrane, T1, fields->T1);
  membrane_nodal_field(s->membrane, T2, fields->T2);
  membrane_nodal_field(s->membrane, view.phi, fields->Y);
  if (view.d) membrane_nodal_field(s->membrane, view.d, fields->d);
  for (int p = 0; p < s->mesh.n_nodes; p++) {
    fields->T1[p] /= G;
    fields->T2[p] /= G;
    fields->Y[p] /= G;
  }
}
