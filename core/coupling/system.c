#include "coupling/system.h"

#include "base/array.h"
#include "mesh/surface.h"
#include <math.h>

Status system_new(CoupledSystem *system, const Mesh *mesh, Membrane *membrane, SingleLayer *layer,
                  const Flow *flow, double mobility, bool keep_volume, Error *error) {
  Status status = STATUS_OK;
  const size_t n = 3 * (size_t)mesh->n_nodes;
  *system = (CoupledSystem){.mesh = mesh,
                            .membrane = membrane,
                            .layer = layer,
                            .flow = flow,
                            .mobility = mobility,
                            .keep_volume = keep_volume,
                            .volume0 = surface_volume(mesh, mesh->X)};
  TRY(ARRAY_NEW(&system->R, n, error));
  TRY(ARRAY_NEW(&system->q, n, error));
  TRY(ARRAY_NEW(&system->u, n, error));
  TRY(ARRAY_NEW(&system->normal, n, error));
  TRY(ARRAY_NEW(&system->area_vector, n, error));
cleanup:
  if (status != STATUS_OK) system_free(system);
  return status;
}

void system_free(CoupledSystem *system) {
  array_free(system->R);
  array_free(system->q);
  array_free(system->u);
  array_free(system->normal);
  array_free(system->area_vector);
  *system = (CoupledSystem){0};
}

/* Area vectors A_p (dV = sum_p dx_p . A_p) and unit normals at x; returns the rate of change of the volume
 * for a unit normal velocity, sum_p n_p . A_p. */
static double measure_normals(CoupledSystem *system, const double *x) {
  double area = 0;
  surface_area_vectors(system->mesh, x, system->area_vector);
  surface_normals(system->mesh, x, system->normal);
  for (int i = 0; i < 3 * system->mesh->n_nodes; i++) area += system->normal[i] * system->area_vector[i];
  return area;
}

/* v <- v - c n, with c such that dV/dt = sum_p v_p . A_p = 0. */
static void remove_mean_flux(CoupledSystem *system, const double *x, double *v) {
  const int n = 3 * system->mesh->n_nodes;
  const double area = measure_normals(system, x);
  double flux = 0;
  for (int i = 0; i < n; i++) flux += v[i] * system->area_vector[i];
  for (int i = 0; i < n; i++) v[i] -= flux / area * system->normal[i];
}

static void restore_volume(CoupledSystem *system, double *x) {
  for (int newton = 0; newton < 2; newton++) { /* from an error e, the second leaves e^4 */
    const double excess = surface_volume(system->mesh, x) - system->volume0;
    const double shift = excess / measure_normals(system, x);
    for (int i = 0; i < 3 * system->mesh->n_nodes; i++) x[i] -= shift * system->normal[i];
  }
}

void system_constrain(CoupledSystem *system, double *x) {
  if (system->keep_volume) restore_volume(system, x);
  if (system->symmetry) symmetry_spread(system->symmetry, x);
}

Status system_velocity(CoupledSystem *system, const double *x, double t, double dt, double *v, Error *error) {
  Status status = STATUS_OK;
  const int n = 3 * system->mesh->n_nodes;
  system->evaluations++;
  TRY(membrane_force(system->membrane, x, t, dt, system->R, error));
  TRY(membrane_load(system->membrane, system->R, system->q, error));
  TRY(single_layer_evaluate(system->layer, x, system->q, system->u, error));
  flow_velocity(system->flow, system->mesh->n_nodes, x, t + dt, v);
  for (int i = 0; i < n; i++) v[i] -= system->mobility * system->u[i];
  if (system->keep_volume) remove_mean_flux(system, x, v);
  if (system->symmetry) symmetry_spread(system->symmetry, v);
  for (int i = 0; i < n; i++)
    if (!isfinite(v[i]))
      return error_set(error, STATUS_REJECT, "the velocity of node %d is not finite", i / 3);
cleanup:
  return status;
}

static Status evaluate(void *context, const double *x, double t, double dt, double *f, Error *error) {
  return system_velocity(context, x, t, dt, f, error);
}

static void constrain(void *context, double *x) {
  system_constrain(context, x);
}

Rhs system_rhs(CoupledSystem *system) {
  return (Rhs){
      .n = 3 * system->mesh->n_nodes, .context = system, .evaluate = evaluate, .constrain = constrain};
}
