#include "membrane/membrane.h"

#include "base/array.h"
#include "base/vec3.h"
#include "membrane/membrane_private.h"
#include "mesh/p2.h"
#include "mesh/quadrature.h"
#include <math.h>
#include <omp.h>
#include <string.h>

/* An element squeezed below this share of its reference area counts as inverted. */
static const double SMALLEST_AREA_RATIO = 1e-6;

/* Fewer blocks are done by one thread: below half a millisecond of work, waiting for the others costs more
 * than they save, and far more on a machine that has other things to do. */
enum { PARALLEL_BLOCKS = 32 };

/* ---- set-up ---- */

static Status fill_basis(Membrane *m, Error *error) {
  const TriangleRule *rule = triangle_rule(RULE_POINTS);
  for (int g = 0; g < RULE_POINTS; g++) {
    p2_values(rule->point[g][0], rule->point[g][1], m->basis.N[g]);
    p2_gradients(rule->point[g][0], rule->point[g][1], m->basis.dN[g]);
    m->rule_weight[g] = rule->weight[g];
    for (int p = 0; p < 6; p++)
      for (int q = p; q < 6; q++) m->basis.NN[mass_pair(p, q)][g] = m->basis.N[g][p] * m->basis.N[g][q];
  }
  if (m->interpolation == INTERPOLATION_QUADRATIC) return STATUS_OK;
  if (m->mesh->subdivisions == 0)
    return error_set(
        error, STATUS_INPUT,
        "membrane.interpolation: quartic takes four elements that come from halving one: expected "
        "capsule.mesh.subdivisions of at least 1, found 0");
  quartic_fill(&m->quartic);
  return STATUS_OK;
}

static Status fill_metric(Membrane *m, int orbit, int g, const double A1[3], const double A2[3],
                          Error *error) {
  const Orbits *elements = &m->symmetry->elements;
  const double A11 = vec3_dot(A1, A1), A12 = vec3_dot(A1, A2), A22 = vec3_dot(A2, A2);
  const double det = A11 * A22 - A12 * A12;
  if (!(det > 0) || !isfinite(det))
    return error_set(error, STATUS_INPUT, "the reference mesh is degenerate in element %d",
                     elements->representative[orbit]);
  const int k = g * m->n_elements + orbit;
  m->A11[k] = A22 / det;
  m->A12[k] = -A12 / det;
  m->A22[k] = A11 / det;
  m->inverse_det[k] = 1 / det;
  m->dS0[k] = m->rule_weight[g] * sqrt(det);
  m->weight[k] = m->dS0[k] * elements->size[orbit];
  return STATUS_OK;
}

static Status fill_reference(Membrane *m, Error *error) {
  Status status = STATUS_OK;
  ElementBlock block;
  for (int first = 0; first < m->n_elements; first += LANES) {
    const int n = membrane_block_size(m, first);
    membrane_base_vectors(m, first, n, m->mesh->X, &block);
    for (int lane = 0; lane < n; lane++)
      for (int g = 0; g < RULE_POINTS; g++) {
        double A[2][3];
        for (int c = 0; c < 3; c++)
          for (int alpha = 0; alpha < 2; alpha++) A[alpha][c] = block.a[g][alpha][c][lane];
        TRY(fill_metric(m, first + lane, g, A[0], A[1], error));
      }
  }
cleanup:
  return status;
}

static Status channels_new(Membrane *m, Error *error) {
  Status status = STATUS_OK;
  m->channel[MLAW_Y] = m->phi;
  m->channel[MLAW_I1] = m->I1;
  m->channel[MLAW_I2] = m->I2;
  for (int c = MLAW_L1; c <= MLAW_T2; c++)
    if (m->channels & (1u << c)) TRY(ARRAY_NEW(&m->channel[c], m->n_points, error));
  for (int c = 0; c < MLAW_N_CHANNELS; c++) {
    if (!(m->channels & (1u << c))) continue;
    if (m->is_nonlocal)
      TRY(ARRAY_NEW(&m->drive[c], m->n_points, error));
    else
      m->drive[c] = m->channel[c];
  }
cleanup:
  return status;
}

static Status average_new(Membrane *m, Error *error) {
  Status status = STATUS_OK;
  double *X = NULL;
  TRY(ARRAY_NEW(&X, 3 * (size_t)m->n_points, error));
  for (int k = 0; k < m->n_points; k++) membrane_point_position(m, k, m->mesh->X, X + 3 * (size_t)k);
  TRY(surface_average_new(&m->average, m->n_points, X, m->weight, m->symmetry, m->material->nonlocal_length,
                          error));
cleanup:
  array_free(X);
  return status;
}

/* Takes the symmetry given, or makes the trivial one. */
static Status choose_symmetry(Membrane *m, const Symmetry *symmetry, Error *error) {
  m->symmetry = symmetry ? symmetry : &m->own_symmetry;
  const Status status = symmetry ? STATUS_OK : symmetry_none(&m->own_symmetry, m->mesh, error);
  if (status != STATUS_OK) return status;
  m->n_elements = m->symmetry->elements.n;
  m->n_points = RULE_POINTS * m->n_elements;
  return STATUS_OK;
}

Status membrane_new(Membrane **membrane, const Mesh *mesh, const Symmetry *symmetry, const Material *material,
                    MembraneMethod method, Error *error) {
  Status status = STATUS_OK;
  Membrane *m = NULL;
  *membrane = NULL;
  TRY(ARRAY_NEW(&m, 1, error));
  m->mesh = mesh;
  m->material = material;
  TRY(choose_symmetry(m, symmetry, error));
  m->has_damage = material_has_damage(material);
  m->channels = material_channels(material);
  m->channel_history = m->has_damage && material->damage.damage->update;
  m->is_nonlocal = m->has_damage && material->nonlocal_length > 0;
  m->interpolation = method.interpolation;
  TRY(fill_basis(m, error));
  double **const arrays[] = {&m->A11,    &m->A12, &m->A22, &m->inverse_det, &m->dS0,
                             &m->weight, &m->I1,  &m->I2,  &m->J,           &m->phi};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) TRY(ARRAY_NEW(arrays[i], m->n_points, error));
  TRY(ARRAY_NEW(&m->dphi, 2 * (size_t)m->n_points, error));
  TRY(ARRAY_NEW(&m->element_force, 18 * (size_t)m->n_elements, error));
  TRY(ARRAY_NEW(&m->element_mass, MASS_PAIRS * (size_t)m->n_elements, error));
  TRY(fill_reference(m, error));
  TRY(channels_new(m, error));
  if (m->is_nonlocal) TRY(average_new(m, error));
  TRY(membrane_history_new(&m->accepted, m, error));
  TRY(membrane_history_new(&m->trial, m, error));
  membrane_history_start(&m->accepted, m);
  TRY(assembly_new(&m->assembly, mesh, m->symmetry, error));
  TRY(mass_new(&m->mass, mesh, m->symmetry, method.solver, error));
  *membrane = m;
cleanup:
  if (status != STATUS_OK) membrane_free(m);
  return status;
}

void membrane_free(Membrane *m) {
  if (!m) return;
  double *const arrays[] = {m->A11, m->A12, m->A22, m->inverse_det, m->dS0,           m->weight,      m->I1,
                            m->I2,  m->J,   m->phi, m->dphi,        m->element_force, m->element_mass};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) array_free(arrays[i]);
  for (int c = MLAW_L1; c <= MLAW_T2; c++) array_free(m->channel[c]);
  for (int c = 0; m->is_nonlocal && c < MLAW_N_CHANNELS; c++) array_free(m->drive[c]);
  surface_average_free(&m->average);
  membrane_history_free(&m->accepted);
  membrane_history_free(&m->trial);
  assembly_free(&m->assembly);
  mass_free(&m->mass);
  law_failure_free(&m->failure);
  symmetry_free(&m->own_symmetry);
  array_free(m);
}

/* ---- one evaluation ---- */

/* The element of the mesh that is computed for an orbit. */
static int mesh_element(const Membrane *m, int orbit) {
  return m->symmetry->elements.representative[orbit];
}

/* What is done to a block: all at once, or what comes before and after the average of a non-local drive. */
typedef enum { ALL, STRAIN, DAMAGE } Stage;

/* One block of computed elements: first .. first + n - 1. */
typedef struct {
  int first, n;
  double t, dt;
  Stage stage;
  LawFailure *failure; /* NULL: not to be kept */
} BlockTask;

static void gather_nodes(const Membrane *m, int first, int n, const double *x, ElementBlock *block) {
  for (int lane = 0; lane < n; lane++) {
    const int *nodes = m->mesh->element[mesh_element(m, first + lane)];
    for (int p = 0; p < 6; p++)
      for (int c = 0; c < 3; c++) block->node[p][c][lane] = x[3 * nodes[p] + c];
  }
}

void membrane_base_vectors(const Membrane *m, int first, int n, const double *x, ElementBlock *block) {
  if (m->interpolation == INTERPOLATION_QUARTIC) {
    for (int lane = 0; lane < n; lane++)
      quartic_base_vectors(&m->quartic, m->mesh, mesh_element(m, first + lane), x, lane, block);
  } else {
    gather_nodes(m, first, n, x, block);
    element_base_vectors(&m->basis, n, block);
  }
}

static Status check_elements(const Membrane *m, BlockTask task, const ElementBlock *block, Error *error) {
  for (int g = 0; g < RULE_POINTS; g++)
    for (int lane = 0; lane < task.n; lane++) {
      const int e = mesh_element(m, task.first + lane);
      const double J = m->J[g * m->n_elements + task.first + lane];
      if (!(J > SMALLEST_AREA_RATIO) || !isfinite(J))
        return error_set(
            error, STATUS_REJECT,
            "element %d has collapsed: area ratio %g at integration point %d (at least %g expected)", e, J, g,
            SMALLEST_AREA_RATIO);
      if (!(block->facing[g][lane] > 0))
        return error_set(error, STATUS_REJECT,
                         "element %d is inverted: its normal turns over at integration point %d", e, g);
    }
  return STATUS_OK;
}

void membrane_watch_laws(Membrane *m, LawWatch *watch) {
  m->watch = watch;
}

/* The slot of this thread. */
static LawWatch *watch_slot(const Membrane *m) {
  return m->watch ? &m->watch[omp_get_thread_num() % LAW_WATCHES] : NULL;
}

/* Laws are called for one rule point of the block at a time: a range of consecutive points in every array. */
static Status call_elastic_law(const Membrane *m, BlockTask task, int g, Error *error) {
  const ptrdiff_t k = g * m->n_elements + task.first;
  ptrdiff_t failing = -1;
  const MembraneHistory *old = &m->accepted, *new = &m->trial;
  const ElasticBatch batch = {
      .n = task.n,
      .ld = m->n_points,
      .first = task.first,
      .t = task.t,
      .dt = task.dt,
      .I1 = m->I1 + k,
      .I2 = m->I2 + k,
      .state0 = old->elastic_state ? old->elastic_state + k : NULL,
      .state1 = new->elastic_state ? new->elastic_state + k : NULL,
      .phi = m->phi + k,
      .dphi = m->dphi + k,
      .failure = task.failure,
  };
  LawWatch *slot = watch_slot(m);
  law_watch_enter(slot, m->material->elastic.energy->id, task.t + task.dt, mesh_element(m, task.first));
  const Status status = material_elastic(m->material, &batch, &failing, error);
  law_watch_leave(slot);
  if (status != STATUS_OK && failing >= 0)
    error_prefix(error, "element %d, integration point %d: ", mesh_element(m, task.first + (int)failing), g);
  return status;
}

static Status call_damage_law(const Membrane *m, BlockTask task, int g, Error *error) {
  const ptrdiff_t k = g * m->n_elements + task.first;
  ptrdiff_t failing = -1;
  const MembraneHistory *old = &m->accepted, *new = &m->trial;
  DamageBatch batch = {
      .n = task.n,
      .ld = m->n_points,
      .first = task.first,
      .t = task.t,
      .dt = task.dt,
      .Ymax0 = old->Ymax + k,
      .d0 = old->d + k,
      .state0 = old->damage_state ? old->damage_state + k : NULL,
      .Ymax1 = new->Ymax + k,
      .d1 = new->d + k,
      .state1 = new->damage_state ? new->damage_state + k : NULL,
      .failure = task.failure,
  };
  if (m->channels >> MLAW_L1 && !m->is_nonlocal)
    principal_values(task.n, m->I1 + k, m->I2 + k, m->dphi + k, m->dphi + m->n_points + k,
                     m->channel[MLAW_L1] ? m->channel[MLAW_L1] + k : NULL,
                     m->channel[MLAW_L2] ? m->channel[MLAW_L2] + k : NULL,
                     m->channel[MLAW_T1] ? m->channel[MLAW_T1] + k : NULL,
                     m->channel[MLAW_T2] ? m->channel[MLAW_T2] + k : NULL);
  for (int c = 0; c < MLAW_N_CHANNELS; c++)
    if (m->channels & (1u << c)) {
      batch.chan[c] = m->drive[c] + k;
      if (m->channel_history) {
        batch.chan0[c] = old->channel[c] + k;
        memcpy(new->channel[c] + k, m->drive[c] + k, (size_t)task.n * sizeof(double));
      }
    }
  LawWatch *slot = watch_slot(m);
  law_watch_enter(slot, m->material->damage.damage->id, task.t + task.dt, mesh_element(m, task.first));
  const Status status = material_damage(m->material, &batch, &failing, error);
  law_watch_leave(slot);
  if (status != STATUS_OK && failing >= 0)
    error_prefix(error, "element %d, integration point %d: ", mesh_element(m, task.first + (int)failing), g);
  return status;
}

ReferenceMetric membrane_metric(const Membrane *m, int first) {
  return (ReferenceMetric){
      .A11 = m->A11 + first,
      .A12 = m->A12 + first,
      .A22 = m->A22 + first,
      .inverse_det = m->inverse_det + first,
      .dS0 = m->dS0 + first,
      .ld = m->n_elements,
  };
}

int membrane_block_size(const Membrane *m, int first) {
  const int left = m->n_elements - first;
  return left < LANES ? left : LANES;
}

static Status evaluate_block(Membrane *m, BlockTask task, const double *x, Error *error) {
  Status status = STATUS_OK;
  const int first = task.first;
  ElementBlock block;
  const ReferenceMetric metric = membrane_metric(m, first);
  membrane_base_vectors(m, first, task.n, x, &block);
  element_kinematics(metric, task.n, &block, m->I1 + first, m->I2 + first, m->J + first);
  TRY(check_elements(m, task, &block, error));
  for (int g = 0; g < RULE_POINTS; g++) {
    if (task.stage != DAMAGE) TRY(call_elastic_law(m, task, g, error));
    if (task.stage != STRAIN && m->has_damage) TRY(call_damage_law(m, task, g, error));
  }
  if (task.stage == STRAIN) goto cleanup;
  element_tensions(metric, task.n, &block, m->dphi + first, m->dphi + m->n_points + first,
                   m->has_damage ? m->trial.d + first : NULL);
  element_force(&m->basis, task.n, &block, m->element_force + first, m->n_elements);
cleanup:
  return status;
}

/* Evaluates a block that failed once more, to keep what the law was handed. */
static void keep_failure(Membrane *m, BlockTask task, const double *x) {
  Error known;
  task.failure = &m->failure;
  evaluate_block(m, task, x, &known);
}

static Status evaluate_blocks(Membrane *m, const double *x, double t, double dt, Stage stage, Error *error) {
  const int n_blocks = (m->n_elements + LANES - 1) / LANES;
  Status status = STATUS_OK;
  int failed_block = n_blocks; /* the first failing block speaks, whatever the order of the threads */
  law_failure_free(&m->failure);
#pragma omp parallel for schedule(static) if (n_blocks >= PARALLEL_BLOCKS)
  for (int b = 0; b < n_blocks; b++) {
    const BlockTask task = {
        .first = b * LANES, .n = membrane_block_size(m, b * LANES), .t = t, .dt = dt, .stage = stage};
    Error block_error;
    const Status block_status = evaluate_block(m, task, x, &block_error);
    if (block_status != STATUS_OK) {
#pragma omp critical(membrane_force_error)
      if (b < failed_block) {
        failed_block = b;
        status = block_status;
        *error = block_error;
      }
    }
  }
  if (status != STATUS_OK) {
    const int first = failed_block * LANES;
    const BlockTask task = {
        .first = first, .n = membrane_block_size(m, first), .t = t, .dt = dt, .stage = stage};
    keep_failure(m, task, x);
  }
  return status;
}

/* Channels that are no views of what the last evaluation left are filled in first. */
static void average_drive(Membrane *m) {
  double *derived[MLAW_N_CHANNELS] = {NULL};
  for (int c = MLAW_L1; c < MLAW_N_CHANNELS; c++) derived[c] = m->channel[c];
  membrane_channels(m, derived);
  for (int c = 0; c < MLAW_N_CHANNELS; c++)
    if (m->drive[c]) surface_average_apply(&m->average, m->channel[c], m->drive[c]);
}

Status membrane_force(Membrane *m, const double *x, double t, double dt, double *R, Error *error) {
  Status status = STATUS_OK;
  if (m->is_nonlocal) {
    TRY(evaluate_blocks(m, x, t, dt, STRAIN, error));
    average_drive(m);
  }
  TRY(evaluate_blocks(m, x, t, dt, m->is_nonlocal ? DAMAGE : ALL, error));
  assembly_sum(&m->assembly, m->element_force, R);
cleanup:
  return status;
}

Status membrane_load(Membrane *m, LoadAccuracy accuracy, const double *R, double *q, Error *error) {
  for (int first = 0; first < m->n_elements; first += LANES)
    element_mass(&m->basis, membrane_metric(m, first), membrane_block_size(m, first), m->J + first,
                 m->element_mass + first, m->n_elements);
  mass_update(&m->mass, m->element_mass);
  return mass_solve(&m->mass, accuracy, R, q, error);
}
