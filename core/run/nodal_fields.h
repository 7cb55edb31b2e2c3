/* What the membrane holds at its integration points, at the nodes. */
#ifndef CAPSELLA_RUN_NODAL_FIELDS_H
#define CAPSELLA_RUN_NODAL_FIELDS_H

#include "base/status.h"
#include "run/simulation.h"

/* [n_nodes]; energy per area and tensions in units of G_s.  d stays zero without a damage law. */
typedef struct {
  double *d, *Y, *T1, *T2;
  double *points; /* [2][n_points] scratch */
} NodalFields;

Status nodal_fields_new(NodalFields *fields, const Simulation *simulation, Error *error);
void nodal_fields_free(NodalFields *fields);

/* Of the membrane's last evaluation. */
void nodal_fields_measure(NodalFields *fields, const Simulation *simulation);

#endif
