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
cleanup:
  if (status != STATUS_OK) system_free(system);
  return status;
}

void system_free(CoupledSystem *system) {
  array_free(system->R);
  array_free(system->q);
  array_free(system->u);
  array_free(system->normal);
  *system = (CoupledSystem){0};
}

/* Unit normals at x; returns the rate of change of the volume for a unit normal velocity, int n . n dS. */
static double measure_normals(CoupledSystem *system, const double *x) {
  surface_orbit_normals(system->mesh, system->symmetry, x, system->normal);
  return surface_flux(system->mesh, system->symmetry, x, system->normal);
}

/* v <- v - c n, with c such that int v . n dS = 0. */
static void remove_mean_flux(CoupledSystem *system, const double *x, double *v) {
  const double c = surface_flux(system->mesh, system->symmetry, x, v) / measure_normals(system, x);
  for (int i = 0; i < 3 * system->mesh->n_nodes; i++) v[i] -= c * system->normal[i];
}

static void restore_volume(CoupledSystem *system, double *x) {
  for (int newton = 0; newton < 2; newton++) { /* from an error e, the second leaves e^4 */
    const double excess = surface_flux(system->mesh, system->symmetry, x, x) / 3 - system->volume0;
    const double shift = excess / measure_normals(system, x);
    for (int i = 0; i < 3 * system->mesh->n_nodes; i++) x[i] -= shift * system->normal[i];
    if (system->symmetry) symmetry_spread(system->symmetry, x);
  }
}

void system_constrain(CoupledSystem *system, double *x) {
  if (system->symmetry) symmetry_spread(system->symmetry, x);
  if (system->keep_volume) restore_volume(system, x);
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
  if (system->symmetry) symmetry_spread(system->symmetry, v);
  if (system->keep_volume) remove_mean_flux(system, x, v);
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
