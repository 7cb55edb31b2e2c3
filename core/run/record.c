#include "run/record.h"

#include "base/array.h"
#include "base/vec3.h"
#include "mesh/surface.h"
#include <math.h>
#include <string.h>

/* What the balance may leave over in a part of a step, of time.tolerance, relative to the largest energy. */
static const double BALANCE_SHARE = 0.1;

/* ---- what the energy balance sees, in the units of the law ---- */

static double power(const Record *record, const double *gradient) {
  double sum = 0;
  for (int i = 0; i < 3 * record->simulation->mesh.n_nodes; i++) sum += gradient[i] * record->v[i];
  return sum;
}

static Status look(void *context, double t, Instant *instant, Error *error) {
  Record *record = context;
  const Membrane *membrane = record->simulation->membrane;
  const Status status = record_probe(record, t, error);
  if (status != STATUS_OK) return status;
  const MembraneRelease release = membrane_release_trial(membrane);
  *instant = (Instant){t, power(record, record->gradient), membrane_energy(membrane), release.Y, release.d};
  return STATUS_OK;
}

/* The accepted state as the start of the proposed step: the velocity may jump there. */
static Instant step_start(Record *record) {
  const Simulation *s = record->simulation;
  const double t = s->motion->t;
  s->motion->at(s->motion, t, record->x, record->v);
  const MembraneRelease release = membrane_release_accepted(s->membrane);
  return (Instant){t, power(record, record->gradient0), record->stored0, release.Y, release.d};
}

/* ---- life ---- */

Status record_new(Record *record, Simulation *s, Error *error) {
  Status status = STATUS_OK;
  const size_t n = 3 * (size_t)s->mesh.n_nodes, points = (size_t)membrane_points(s->membrane);
  *record = (Record){.simulation = s, .probed_t = NAN};
  record->data = (RecordData){.t_c = NAN, .t_l = NAN, .steady_since = NAN, .sample_t = NAN, .film_min = NAN};
  TRY(ARRAY_NEW(&record->x, n, error));
  TRY(ARRAY_NEW(&record->v, n, error));
  TRY(ARRAY_NEW(&record->R, n, error));
  TRY(ARRAY_NEW(&record->gradient, n, error));
  TRY(ARRAY_NEW(&record->gradient0, n, error));
  TRY(ARRAY_NEW(&record->T1, points, error));
  TRY(ARRAY_NEW(&record->T2, points, error));
  if (simulation_is_inflation(s)) {
    TRY(ARRAY_NEW(&record->area_vector, n, error));
    TRY(ARRAY_NEW(&record->load, n, error));
  } else {
    TRY(contact_search_new(&record->contact, &s->mesh, error));
    TRY(wrinkles_new(&record->wrinkles, &s->mesh, &s->symmetry, error));
  }
  TRY(balance_new(&record->balance, material_has_damage(&s->material) ? (int)points : 0, error));
  record->balance.look = look;
  record->balance.context = record;
  record->balance.area = membrane_points_view(s->membrane).dS0;
  TRY(criteria_new(&record->criteria, s, error));
cleanup:
  if (status != STATUS_OK) record_free(record);
  return status;
}

void record_free(Record *record) {
  array_free(record->x);
  array_free(record->v);
  array_free(record->R);
  array_free(record->gradient);
  array_free(record->gradient0);
  array_free(record->T1);
  array_free(record->T2);
  array_free(record->area_vector);
  array_free(record->load);
  balance_free(&record->balance);
  criteria_free(&record->criteria);
  contact_search_free(record->contact);
  wrinkles_free(record->wrinkles);
  *record = (Record){0};
}

/* ---- energies up to the probed time, in units of G_s a^2 ---- */

/* Of the fluid on the membrane. */
static double work_done(const Record *record) {
  const Simulation *s = record->simulation;
  const RecordData *data = &record->data;
  if (record->probed_t == s->motion->t) return data->work;
  return data->work + balance_work(&record->balance, record->probed_t) / s->material.shear_modulus;
}

static double stored(const Record *record) {
  const Simulation *s = record->simulation;
  return membrane_energy(s->membrane) / s->material.shear_modulus;
}

static double dissipated(const Record *record) {
  const Simulation *s = record->simulation;
  const bool is_end = record->probed_t == record->t1 && record->t1 > s->motion->t;
  const double of_step = is_end ? record->balance.dissipated : membrane_dissipation(s->membrane);
  return record->data.dissipated + of_step / s->material.shear_modulus;
}

typedef struct {
  double stored, dissipated, work;
  double scale; /* the largest of them so far */
} Energies;

static Energies energies(const Record *record) {
  Energies e = {.stored = stored(record), .dissipated = dissipated(record), .work = work_done(record)};
  e.scale = fmax(record->data.energy_scale, fmax(fabs(e.work), e.stored + e.dissipated));
  return e;
}

/* What the energy balance leaves over, stored + dissipated - work, relative to the largest energy so far (a
 * capsule that comes back to rest holds none). */
static double energy_error(Energies e) {
  return e.scale > 0 ? (e.stored + e.dissipated - e.work) / e.scale : 0;
}

/* ---- probing ---- */

/* What the next step starts from. */
static void keep_start(Record *record) {
  memcpy(record->gradient0, record->gradient,
         3 * (size_t)record->simulation->mesh.n_nodes * sizeof *record->R);
  record->stored0 = membrane_energy(record->simulation->membrane);
}

Status record_begin(Record *record, bool restored, Error *error) {
  const Status status = record_probe(record, record->simulation->motion->t, error);
  if (status != STATUS_OK) return status;
  keep_start(record);
  record->t1 = record->probed_t;
  if (restored) return STATUS_OK;
  record->data.work = stored(record) + dissipated(record); /* an inflation may start inflated */
  return criteria_begin(record, error);
}

Status record_probe(Record *record, double t, Error *error) {
  if (t == record->probed_t) return STATUS_OK;
  const Simulation *s = record->simulation;
  record->probed_t = t;
  s->motion->at(s->motion, t, record->x, record->v);
  const double t0 = s->motion->t;
  Status status = membrane_force(s->membrane, record->x, t0, t - t0, record->R, error);
  /* Both ends of the step are admissible; a point between that is not means that the step was too long. */
  if (status == STATUS_REJECT) {
    status = error->code = STATUS_FAILED;
    error_prefix(error, "inside the step from t = %.6g to %.6g: ", t0, record->t1);
  }
  if (status != STATUS_OK) return status;
  memcpy(record->gradient, record->R, 3 * (size_t)s->mesh.n_nodes * sizeof *record->R);
  membrane_energy_gradient(s->membrane, record->x, record->gradient);
  return STATUS_OK;
}

Status record_step(Record *record, double t1, Error *error) {
  const Simulation *s = record->simulation;
  const Instant start = step_start(record);
  record->t1 = t1;
  record->probed_t = NAN; /* the motion is another */
  return balance_step(&record->balance, &start, t1, BALANCE_SHARE * s->scene->time.tolerance,
                      record->data.energy_scale * s->material.shear_modulus, error);
}

/* ---- extremes ---- */

static double largest_damage(const Record *record) {
  const Membrane *membrane = record->simulation->membrane;
  const double *d = membrane_points_view(membrane).d;
  return d ? d[membrane_largest(membrane, d)] : 0;
}

static double largest_release_rate(const Record *record) {
  const Membrane *membrane = record->simulation->membrane;
  const double *phi = membrane_points_view(membrane).phi;
  const double now = phi[membrane_largest(membrane, phi)] / record->simulation->material.shear_modulus;
  return fmax(now, record->data.Y_max);
}

void record_peak(const Record *record, double X[3], double x[3]) {
  const Simulation *s = record->simulation;
  const MembranePoints points = membrane_points_view(s->membrane);
  const int k = membrane_largest(s->membrane, points.d ? points.d : points.phi);
  membrane_point_position(s->membrane, k, s->mesh.X, X);
  membrane_point_position(s->membrane, k, record->x, x);
}

/* ---- places ---- */

Status record_shape(const Record *record, Shape *shape, Error *error) {
  const Simulation *s = record->simulation;
  return shape_measure(&s->mesh, &s->symmetry, record->x, s->flow.vorticity_axis, shape, error);
}

Site record_site(const Record *record, const Shape *shape, int k) {
  const Simulation *s = record->simulation;
  double X[3], x[3];
  membrane_point_position(s->membrane, k, s->mesh.X, X);
  membrane_point_position(s->membrane, k, record->x, x);
  return site_measure(shape, simulation_is_inflation(s) ? shape->e3 : s->flow.vorticity_axis, X, x);
}

/* ---- rows ---- */

/* The load of the motion is that at the end of the step: the one at the probed time is near. */
static Status probed_load(Record *record, Error *error) {
  const Simulation *s = record->simulation;
  memcpy(record->load, s->motion->q, 3 * (size_t)s->mesh.n_nodes * sizeof *record->load);
  return membrane_load(s->membrane, LOAD_FULL, record->R, record->load, error);
}

static Status inflation_averages(Record *record, HistoryRow *row, Error *error) {
  const Simulation *s = record->simulation;
  const MembranePoints points = membrane_points_view(s->membrane);
  double area = 0, damaged = 0, load = 0;
  const Status status = probed_load(record, error);
  if (status != STATUS_OK) return status;
  for (int k = 0; k < membrane_points(s->membrane); k++) {
    area += points.J[k] * points.dS0[k];
    if (points.d) damaged += points.d[k] * points.J[k] * points.dS0[k];
  }
  double *A = record->area_vector;
  surface_area_vectors(&s->mesh, NULL, record->x, A);
  for (int i = 0; i < 3 * s->mesh.n_nodes; i++) load += record->load[i] * A[i];
  row->p = load / area / s->material.shear_modulus;
  row->d = damaged / area;
  row->alpha = inflation_alpha(&s->inflated, record->probed_t);
  return STATUS_OK;
}

Status record_row(Record *record, HistoryRow *row, Shape *shape, Error *error) {
  Status status = STATUS_OK;
  const Simulation *s = record->simulation;
  const double G = s->material.shear_modulus;
  const int n = membrane_points(s->membrane);
  TRY(record_shape(record, shape, error));
  membrane_principal_tensions(s->membrane, record->T1, record->T2);
  double T1_max = -INFINITY, T2_min = INFINITY;
  for (int k = 0; k < n; k++) {
    T1_max = fmax(T1_max, record->T1[k]);
    T2_min = fmin(T2_min, record->T2[k]);
  }
  const Energies energy = energies(record);
  *row = (HistoryRow){
      .t = record->probed_t,
      .D12 = shape->D12,
      .beta = shape->beta,
      .L1 = shape->L1,
      .L2 = shape->L2,
      .L3 = shape->L3,
      .area_strain = shape->area / s->area0 - 1,
      .volume_error = shape->volume / s->volume0 - 1,
      .d_max = largest_damage(record),
      .Y_max = largest_release_rate(record),
      .T1_max = T1_max / G,
      .T2_min = T2_min / G,
      .compressed_area = membrane_compressed_area(s->membrane, record->T2),
      .wrinkle_amplitude = record->wrinkles ? wrinkles_amplitude(record->wrinkles, record->x) : 0,
      .elastic_energy = energy.stored,
      .dissipated_energy = energy.dissipated,
      .energy_error = energy_error(energy),
      .step = record->probed_t > s->motion->t ? record->t1 - s->motion->t : s->motion->last_step,
      .evaluations = s->motion->evaluations(s->motion),
  };
  if (simulation_is_inflation(s)) TRY(inflation_averages(record, row, error));
cleanup:
  return status;
}

/* ---- events ---- */

Status record_locate(Record *record, RecordTest *happened, const void *context, double *t, Error *error) {
  Status status = STATUS_OK;
  double before = record->simulation->motion->t, after = record->t1;
  const double resolution = 1e-6 * (record->t1 - before);
  while (after - before > resolution) {
    const double middle = 0.5 * (before + after);
    bool is_over;
    TRY(record_probe(record, middle, error));
    TRY(happened(record, context, &is_over, error));
    *(is_over ? &after : &before) = middle;
  }
  TRY(record_probe(record, after, error));
  *t = after;
cleanup:
  return status;
}

static Status is_damaged(Record *record, const void *context, bool *answer, Error *error) {
  (void)context;
  (void)error;
  *answer = largest_damage(record) > 0;
  return STATUS_OK;
}

static Status is_ruptured(Record *record, const void *context, bool *answer, Error *error) {
  (void)context;
  (void)error;
  *answer = largest_damage(record) >= 1;
  return STATUS_OK;
}

static Status note_rupture(Record *record, Error *error) {
  Status status = STATUS_OK;
  const Membrane *membrane = record->simulation->membrane;
  const double *d = membrane_points_view(membrane).d;
  Shape shape;
  TRY(record_shape(record, &shape, error));
  record->data.rupture = record_site(record, &shape, membrane_largest(membrane, d));
  record->data.rupture_area = membrane_damaged_area(membrane, d);
cleanup:
  return status;
}

Status record_events(Record *record, Error *error) {
  Status status = STATUS_OK;
  RecordData *data = &record->data;
  const double d = largest_damage(record); /* at t1 */
  if (isnan(data->t_c) && d > 0) TRY(record_locate(record, is_damaged, NULL, &data->t_c, error));
  if (isnan(data->t_l) && d >= 1) {
    TRY(record_locate(record, is_ruptured, NULL, &data->t_l, error));
    TRY(note_rupture(record, error));
  }
cleanup:
  return status;
}

Status record_advance(Record *record, Error *error) {
  Status status = STATUS_OK;
  RecordData *data = &record->data;
  const Simulation *s = record->simulation;
  TRY(criteria_advance(record, error));
  TRY(record_probe(record, record->t1, error));
  const Energies energy = energies(record);
  data->energy_scale = energy.scale;
  data->energy_error_max = fmax(data->energy_error_max, fabs(energy_error(energy)));
  data->volume_error_max =
      fmax(data->volume_error_max,
           fabs(surface_flux(&s->mesh, &s->symmetry, record->x, record->x) / (3 * s->volume0) - 1));
  data->Y_max = largest_release_rate(record);
  data->dissipated = energy.dissipated;
  data->work = energy.work;
  keep_start(record);
cleanup:
  return status;
}

/* ---- summary ---- */

Status record_summary(Record *record, Summary *summary, Error *error) {
  Status status = STATUS_OK;
  const Simulation *s = record->simulation;
  const RecordData *data = &record->data;
  HistoryRow row;
  Shape shape;
  TRY(record_row(record, &row, &shape, error));
  *summary = (Summary){
      .t = row.t,
      .D12 = row.D12,
      .beta = row.beta,
      .L1 = row.L1,
      .L2 = row.L2,
      .L3 = row.L3,
      .area_strain = row.area_strain,
      .volume_error = row.volume_error,
      .volume_error_max = simulation_is_inflation(s) ? NAN : data->volume_error_max,
      .d_max = row.d_max,
      .Y_max = row.Y_max,
      .t_c = data->t_c,
      .t_l = data->t_l,
      .has_rupture = !isnan(data->t_l),
      .energy_error_max = data->energy_error_max,
      .film_min = data->film_min,
      .wrinkle_amplitude_max = simulation_is_inflation(s) ? NAN : data->wrinkle_max,
      .elements = s->mesh.n_elements,
      .nodes = s->mesh.n_nodes,
      .skipped = s->skipped,
      .n_skipped = s->n_skipped,
  };
  if (s->scene->flow.is_physical) {
    summary->length_scale = s->scales.length;
    summary->time_scale = s->scales.time;
    summary->tension_scale = s->scene->flow.shear_modulus.value;
  }
  record_peak(record, summary->d_max_location.X, summary->d_max_location.x);
  summary->rupture = data->rupture;
  summary->damaged_area_fraction = data->rupture_area;
cleanup:
  return status;
}
