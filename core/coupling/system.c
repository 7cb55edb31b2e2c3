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
  TRY(ARRAY_NEW(&system->A, n, error));
  TRY(ARRAY_NEW(&system->normal, n, error));
cleanup:
  if (status != STATUS_OK) system_free(system);
  return status;
}

void system_free(CoupledSystem *system) {
  array_free(system->R);
  array_free(system->q);
  array_free(system->u);
  array_free(system->A);
  array_free(system->normal);
  array_free(system->lack);
  *system = (CoupledSystem){0};
}

Status system_use_coarse(CoupledSystem *system, CoarseLayer *coarse, Error *error) {
  system->coarse = coarse;
  return ARRAY_NEW(&system->lack, 3 * (size_t)system->mesh->n_nodes, error);
}

bool system_sum_in_full(CoupledSystem *system) {
  const bool is_change = system->coarse != NULL;
  system->coarse = NULL;
  return is_change;
}

static double flux(const CoupledSystem *system, const double *v) {
  double sum = 0;
  for (int i = 0; i < 3 * system->mesh->n_nodes; i++) sum += system->A[i] * v[i];
  return sum;
}

static void measure_area_vectors(CoupledSystem *system, const double *x) {
  surface_area_vectors(system->mesh, system->symmetry, x, system->A);
}

/* Unit normals at x, where the area vectors have been measured; returns the flux of a unit normal velocity,
 * int n . n dS. */
static double measure_normals(CoupledSystem *system, const double *x) {
  surface_normals(system->mesh, x, system->normal);
  if (system->symmetry) symmetry_spread(system->symmetry, system->normal);
  return flux(system, system->normal);
}

/* v <- v - c n, with c such that int v . n dS = 0. */
static void remove_mean_flux(CoupledSystem *system, const double *x, double *v) {
  measure_area_vectors(system, x);
  const double unit = measure_normals(system, x), c = flux(system, v) / unit;
  for (int i = 0; i < 3 * system->mesh->n_nodes; i++) v[i] -= c * system->normal[i];
}

/* From an error e, two steps of Newton's method leave e^4: more are for fixed steps that are far too long. */
static void restore_volume(CoupledSystem *system, double *x) {
  for (int newton = 0; newton < 6; newton++) {
    measure_area_vectors(system, x);
    const double excess = flux(system, x) / 3 - system->volume0;
    if (newton >= 2 && fabs(excess) <= 1e-12 * system->volume0) break;
    const double shift = excess / measure_normals(system, x);
    for (int i = 0; i < 3 * system->mesh->n_nodes; i++) x[i] -= shift * system->normal[i];
    if (system->symmetry) symmetry_spread(system->symmetry, x);
  }
}

void system_constrain(CoupledSystem *system, double *x) {
  if (system->symmetry) symmetry_spread(system->symmetry, x);
  if (system->keep_volume) restore_volume(system, x);
}

static Status check_finite(const CoupledSystem *system, const double *v, Error *error) {
  for (int i = 0; i < 3 * system->mesh->n_nodes; i++)
    if (!isfinite(v[i]))
      return error_set(error, STATUS_REJECT, "the velocity of node %d is not finite", i / 3);
  return STATUS_OK;
}

static Status load(CoupledSystem *system, LoadAccuracy accuracy, const double *x, double t, double dt,
                   Error *error) {
  Status status = STATUS_OK;
  system->evaluations++;
  TRY(membrane_force(system->membrane, x, t, dt, system->R, error));
  TRY(membrane_load(system->membrane, accuracy, system->R, system->q, error));
cleanup:
  return status;
}

/* v = v_inf - mobility u. */
static void add_flow(const CoupledSystem *system, const double *x, double t, double *v) {
  flow_velocity(system->flow, system->mesh->n_nodes, x, t, v);
  for (int i = 0; i < 3 * system->mesh->n_nodes; i++) v[i] -= system->mobility * system->u[i];
}

Status system_velocity(CoupledSystem *system, const double *x, double t, double dt, double *v, Error *error) {
  Status status = STATUS_OK;
  TRY(load(system, LOAD_FULL, x, t, dt, error));
  TRY(single_layer_evaluate(system->layer, x, system->q, system->u, error));
  add_flow(system, x, t + dt, v);
  if (system->symmetry) symmetry_spread(system->symmetry, v);
  if (system->keep_volume) remove_mean_flux(system, x, v);
  TRY(check_finite(system, v, error));
cleanup:
  return status;
}

static Status evaluate(void *context, const double *x, double t, double dt, double *f, Error *error) {
  return system_velocity(context, x, t, dt, f, error);
}

static Status coarse_velocity(CoupledSystem *system, const double *x, double t, double dt, double *v,
                              Error *error) {
  Status status = STATUS_OK;
  system->coarse_evaluations++;
  TRY(load(system, LOAD_COARSE, x, t, dt, error));
  TRY(coarse_layer_evaluate(system->coarse, x, system->q, system->u, error));
  add_flow(system, x, t + dt, v);
cleanup:
  return status;
}

static Status open_step(void *context, const double *x, double t, const double *f, Error *error) {
  Status status = STATUS_OK;
  CoupledSystem *system = context;
  if (!system->coarse) return STATUS_OK;
  coarse_layer_settle(system->coarse);
  TRY(coarse_velocity(system, x, t, 0, system->lack, error));
  for (int i = 0; i < 3 * system->mesh->n_nodes; i++) system->lack[i] = f[i] - system->lack[i];
cleanup:
  return status;
}

static Status evaluate_stage(void *context, const double *x, double t, double dt, double *f, Error *error) {
  Status status = STATUS_OK;
  CoupledSystem *system = context;
  if (!system->coarse) return system_velocity(system, x, t, dt, f, error);
  TRY(coarse_velocity(system, x, t, dt, f, error));
  for (int i = 0; i < 3 * system->mesh->n_nodes; i++) f[i] += system->lack[i];
  TRY(check_finite(system, f, error));
cleanup:
  return status;
}

static void constrain(void *context, double *x) {
  system_constrain(context, x);
}

static double damage_growth(void *context) {
  return membrane_damage_growth(((const CoupledSystem *)context)->membrane);
}

Rhs system_rhs(CoupledSystem *system) {
  Rhs rhs = {.n = 3 * system->mesh->n_nodes,
             .context = system,
             .evaluate = evaluate,
             .constrain = constrain,
             .damage_growth = damage_growth};
  if (system->coarse) {
    rhs.open_step = open_step;
    rhs.stage = evaluate_stage;
  }
  return rhs;
}
