/* A material from a scene, and the two hot calls: batches of the elastic and of the damage law.  The hot
 * calls allocate nothing and touch only the arrays handed in; their loops are plain so that they vectorise.
 */
#include "laws/material.h"

#include "base/array.h"
#include "config/place.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* ---- Checks of values ---- */

/* Verdicts on many points are collected as the bits of doubles: a subtraction and an OR of integers, which
 * vectorise on every machine, where comparisons do not. */
static inline uint64_t bits(double x) {
  uint64_t pattern;
  memcpy(&pattern, &x, sizeof pattern);
  return pattern;
}

static inline bool has_sign(uint64_t pattern) {
  return pattern >> 63;
}

/* First entry that is not finite, or -1.  x - x is 0, without a bit set, exactly for finite x. */
static ptrdiff_t first_not_finite(const double *x, ptrdiff_t n) {
  uint64_t any = 0;
  for (ptrdiff_t i = 0; i < n; i++) any |= bits(x[i] - x[i]);
  if (!any) return -1;
  ptrdiff_t i = 0;
  while (isfinite(x[i])) i++;
  return i;
}

/* First entry of finite I2 at which no area is left (I2 <= -1), or -1. */
static ptrdiff_t first_collapsed(const double *x, ptrdiff_t n) {
  uint64_t any = 0;
  for (ptrdiff_t i = 0; i < n; i++) any |= bits((x[i] + 1.0) - DBL_MIN);
  if (!has_sign(any)) return -1;
  ptrdiff_t i = 0;
  while (x[i] > -1.0) i++;
  return i;
}

/* Refuses the trial step when an output [n_rows][ld] holds a value that is not finite. */
static Status check_finite(const char *law, const char *what, const double *x, ptrdiff_t n_rows, ptrdiff_t n,
                           ptrdiff_t ld, ptrdiff_t *point, Error *error) {
  if (!x) return STATUS_OK;
  for (ptrdiff_t k = 0; k < n_rows; k++) {
    const ptrdiff_t i = first_not_finite(x + k * ld, n);
    if (i < 0) continue;
    if (point) *point = i;
    return error_set(error, STATUS_REJECT, "law %s: expected a finite %s, found %g at point %td of the batch",
                     law, what, x[k * ld + i], i);
  }
  return STATUS_OK;
}

/* A law's status as one of ours: above 0 a smaller step may do, below 0 the run stops. */
static Status law_says(const char *law, int code, const mlaw_error *err, ptrdiff_t n, ptrdiff_t *point,
                       Error *error) {
  if (code == MLAW_OK) return STATUS_OK;
  const bool known = err->point >= 0 && err->point < n;
  error_set(error, code > 0 ? STATUS_REJECT : STATUS_FAILED, "%.*s (status %d)", (int)sizeof err->text - 1,
            err->text[0] ? err->text : "the law gives no reason", code);
  if (!known) return error_prefix(error, "law %s: ", law);
  if (point) *point = (ptrdiff_t)err->point;
  return error_prefix(error, "law %s, point %lld of the batch: ", law, (long long)err->point);
}

/* ---- Parameters of a batch ---- */

/* Parameters of a law that varies, at most; the loader's laws have a handful. */
enum { MAX_VARYING = 64 };

typedef struct {
  mlaw_field field[MAX_VARYING];
} BatchFields;

/* The parameters as seen from element `first` on: `shifted` is used only when some vary. */
static const mlaw_field *fields_from(const ParameterValues *values, const mlaw_field *field, ptrdiff_t first,
                                     BatchFields *shifted) {
  if (!values->varies || first == 0) return field;
  for (uint32_t k = 0; k < values->n; k++)
    shifted->field[k] = (mlaw_field){field[k].v + first * field[k].inc, field[k].inc};
  return shifted->field;
}

/* ---- The elastic law ---- */

static Status check_strain(const ElasticBatch *batch, ptrdiff_t *point, Error *error) {
  ptrdiff_t i = first_not_finite(batch->I1, batch->n);
  if (i < 0) i = first_not_finite(batch->I2, batch->n);
  if (i < 0) i = first_collapsed(batch->I2, batch->n);
  if (i < 0) return STATUS_OK;
  if (point) *point = i;
  return error_set(error, STATUS_REJECT,
                   "expected finite strains and I2 > -1, found I1 = %g, I2 = %g at point %td of the batch",
                   batch->I1[i], batch->I2[i], i);
}

/* Appends rows [n_rows][ld] to a call. */
static void add_rows(LawCall *call, const double *rows, uint32_t n_rows, ptrdiff_t ld) {
  for (uint32_t k = 0; k < n_rows; k++, call->n_rows++)
    if (call->n_rows < FAILURE_ROWS) call->row[call->n_rows] = rows + (ptrdiff_t)k * ld;
}

static void keep_elastic_failure(const Material *material, const ElasticBatch *batch, const mlaw_field *param,
                                 const char *message) {
  LawCall call = {.n = batch->n, .t = batch->t, .dt = batch->dt, .param = param};
  add_rows(&call, batch->I1, 1, batch->ld);
  add_rows(&call, batch->I2, 1, batch->ld);
  add_rows(&call, batch->state0, material->elastic.energy->n_vars, batch->ld);
  law_failure_keep(batch->failure, &material->elastic, &call, message);
}

Status material_elastic(const Material *material, const ElasticBatch *batch, ptrdiff_t *point, Error *error) {
  const mlaw_energy *law = material->elastic.energy;
  const ptrdiff_t n = batch->n, ld = batch->ld;
  bool asked = false;
  mlaw_error err = {.point = -1};
  BatchFields shifted;
  const mlaw_energy_args arguments = {
      .size = sizeof arguments,
      .n = n,
      .ld = ld,
      .t = batch->t,
      .dt = batch->dt,
      .param = fields_from(&material->elastic_values, material->elastic_field, batch->first, &shifted),
      .I1 = batch->I1,
      .I2 = batch->I2,
      .state0 = batch->state0,
      .state1 = batch->state1,
      .phi = batch->phi,
      .dphi = batch->dphi,
      .d2phi = batch->d2phi,
      .err = &err};
  Status status;
  if (point) *point = -1;
  TRY(check_strain(batch, point, error));
  asked = true;
  TRY(law_says(law->id, law->eval(&arguments), &err, n, point, error));
  TRY(check_finite(law->id, "phi", batch->phi, 1, n, ld, point, error));
  TRY(check_finite(law->id, "dphi", batch->dphi, 2, n, ld, point, error));
  TRY(check_finite(law->id, "d2phi", batch->d2phi, 3, n, ld, point, error));
  TRY(check_finite(law->id, "state1", batch->state1, law->n_vars, n, ld, point, error));
cleanup:
  if (status != STATUS_OK && asked && batch->failure)
    keep_elastic_failure(material, batch, arguments.param, error->text);
  return status;
}

/* ---- The damage law ---- */

/* Ymax1 = max(Ymax0, Y); says whether any point went beyond what it has seen (NaN counts as beyond). */
static bool update_Ymax(ptrdiff_t n, const double *restrict Y, const double *restrict Ymax0,
                        double *restrict Ymax1) {
  uint64_t differences = 0, not_finite = 0;
  for (ptrdiff_t i = 0; i < n; i++) {
    Ymax1[i] = Ymax0[i] > Y[i] ? Ymax0[i] : Y[i];
    differences |= bits(Ymax0[i] - Y[i]);
    not_finite |= bits(Y[i] - Y[i]);
  }
  return has_sign(differences) || not_finite;
}

/* d1 = min(d_max, max(d0, d1)) */
static void confine(ptrdiff_t n, double d_max, const double *restrict d0, double *restrict d1) {
  for (ptrdiff_t i = 0; i < n; i++) {
    const double d = d1[i] > d0[i] ? d1[i] : d0[i];
    d1[i] = d < d_max ? d : d_max;
  }
}

/* The law's zeta at Ymax1 goes to d1, to be confined there. */
static Status evolve(const Material *material, const DamageBatch *batch, ptrdiff_t *point, Error *error) {
  const mlaw_damage *law = material->damage.damage;
  const double *chan[MLAW_N_CHANNELS] = {[MLAW_Y] = batch->Ymax1};
  mlaw_error err = {.point = -1};
  BatchFields shifted;
  const mlaw_damage_args arguments = {
      .size = sizeof arguments,
      .n_channels = MLAW_N_CHANNELS,
      .n = batch->n,
      .ld = batch->ld,
      .t = batch->t,
      .dt = batch->dt,
      .param = fields_from(&material->damage_values, material->damage_field, batch->first, &shifted),
      .chan = chan,
      .d0 = batch->d0,
      .zeta = batch->d1,
      .err = &err};
  Status status;
  TRY(law_says(law->id, law->evolution(&arguments), &err, batch->n, point, error));
  TRY(check_finite(law->id, "zeta", batch->d1, 1, batch->n, batch->ld, point, error));
cleanup:
  return status;
}

/* Rounding in a law may cost this much of d; more is a law that heals. */
static const double DAMAGE_ROUNDING = 1e-12;

static Status refuse_healing(const char *law, const DamageBatch *batch, ptrdiff_t *point, Error *error) {
  for (ptrdiff_t i = 0; i < batch->n; i++) {
    if (batch->d1[i] >= batch->d0[i] - DAMAGE_ROUNDING) continue;
    if (point) *point = i;
    return error_set(error, STATUS_FAILED,
                     "law %s: expected damage that never falls, found %g after %g at point %td of the batch",
                     law, batch->d1[i], batch->d0[i], i);
  }
  return STATUS_OK;
}

static Status step(const Material *material, const DamageBatch *batch, ptrdiff_t *point, Error *error) {
  const mlaw_damage *law = material->damage.damage;
  const double *chan0[MLAW_N_CHANNELS] = {NULL}, *chan[MLAW_N_CHANNELS] = {NULL};
  for (int c = 0; c < MLAW_N_CHANNELS; c++) {
    if (!(law->needs & 1u << c)) continue; /* the batch may hold Y for the host alone */
    chan0[c] = batch->chan0[c];
    chan[c] = batch->chan[c];
  }
  mlaw_error err = {.point = -1};
  BatchFields shifted;
  const mlaw_damage_args arguments = {
      .size = sizeof arguments,
      .n_channels = MLAW_N_CHANNELS,
      .n = batch->n,
      .ld = batch->ld,
      .t = batch->t,
      .dt = batch->dt,
      .param = fields_from(&material->damage_values, material->damage_field, batch->first, &shifted),
      .chan0 = chan0,
      .chan = chan,
      .d0 = batch->d0,
      .state0 = batch->state0,
      .state1 = batch->state1,
      .d1 = batch->d1,
      .err = &err};
  Status status;
  TRY(law_says(law->id, law->update(&arguments), &err, batch->n, point, error));
  TRY(check_finite(law->id, "damage", batch->d1, 1, batch->n, batch->ld, point, error));
  TRY(check_finite(law->id, "state1", batch->state1, law->n_vars, batch->n, batch->ld, point, error));
  TRY(refuse_healing(law->id, batch, point, error));
cleanup:
  return status;
}

/* The rows of a damage law: Y and d, or the channels that it reads at both ends of the step, d and state. */
static void keep_damage_failure(const Material *material, const DamageBatch *batch, const char *message) {
  const mlaw_damage *law = material->damage.damage;
  BatchFields shifted;
  LawCall call = {.n = batch->n, .t = batch->t, .dt = batch->dt};
  call.param = fields_from(&material->damage_values, material->damage_field, batch->first, &shifted);
  if (law->evolution) {
    add_rows(&call, batch->Ymax1, 1, batch->ld);
  } else {
    for (int end = 0; end < 2; end++)
      for (int c = 0; c < MLAW_N_CHANNELS; c++)
        if (law->needs & 1u << c) add_rows(&call, end ? batch->chan[c] : batch->chan0[c], 1, batch->ld);
  }
  add_rows(&call, batch->d0, 1, batch->ld);
  add_rows(&call, batch->state0, law->n_vars, batch->ld);
  law_failure_keep(batch->failure, &material->damage, &call, message);
}

Status material_damage(const Material *material, const DamageBatch *batch, ptrdiff_t *point, Error *error) {
  const mlaw_damage *law = material->damage.damage;
  Status status;
  if (point) *point = -1;
  const bool grown = update_Ymax(batch->n, batch->chan[MLAW_Y], batch->Ymax0, batch->Ymax1);
  if (law->evolution && !grown) { /* elastic or unloading everywhere: nothing to ask */
    memcpy(batch->d1, batch->d0, (size_t)batch->n * sizeof *batch->d1);
    return STATUS_OK;
  }
  TRY(check_finite("of the membrane", "Y", batch->chan[MLAW_Y], 1, batch->n, batch->ld, point, error));
  status = law->evolution ? evolve(material, batch, point, error) : step(material, batch, point, error);
  if (status != STATUS_OK && batch->failure) keep_damage_failure(material, batch, error->text);
  TRY(status);
  confine(batch->n, material->d_max, batch->d0, batch->d1);
cleanup:
  return status;
}

/* ---- Moduli at rest ---- */

/* Differences about rest along (I1, I2) = (s, s), which is admissible for either sign of s: of fourth order,
 * error about 1e-11. */
enum { REST_POINTS = 5 };
static const double REST_STEP = 1e-3;

static double slope_at_rest(const mlaw_energy *law, const double *dphi, const double *d2phi) {
  if (law->flags & MLAW_HESSIAN) return d2phi[0] + 2.0 * d2phi[REST_POINTS] + d2phi[2 * REST_POINTS];
  double g[REST_POINTS];
  for (int i = 0; i < REST_POINTS; i++) g[i] = dphi[i] + dphi[REST_POINTS + i];
  return (g[1] - 8.0 * g[2] + 8.0 * g[3] - g[4]) / (12.0 * REST_STEP);
}

/* Laws that are not at rest at rest, or not stable there, are refused. */
static Status check_rest(const Material *material, double phi, double tension, Error *error) {
  const char *id = material->elastic.energy->id;
  const double G = material->shear_modulus, K = material->dilatation_modulus;
  if (!(G > 0.0 && K > 0.0)) {
    return error_set(error, STATUS_INPUT,
                     "law %s: expected positive moduli at rest, found G_s = %g and K_s = %g", id, G, K);
  }
  if (fabs(phi) > 1e-10 * G || fabs(tension) > 1e-10 * G) {
    return error_set(error, STATUS_INPUT,
                     "law %s: expected no energy and no tension at rest, found phi = %g and T = %g", id, phi,
                     tension);
  }
  return STATUS_OK;
}

/* The moduli with one set of parameters for all points. */
static Status measure_moduli(Material *material, const double *strain, double *state, Error *error) {
  const mlaw_energy *law = material->elastic.energy;
  double phi[REST_POINTS], dphi[2 * REST_POINTS], d2phi[3 * REST_POINTS];
  Status status;
  const ElasticBatch batch = {.n = REST_POINTS,
                              .ld = REST_POINTS,
                              .I1 = strain,
                              .I2 = strain,
                              .state0 = law->n_vars ? state : NULL,
                              .state1 = law->n_vars ? state + REST_POINTS * law->n_vars : NULL,
                              .phi = phi,
                              .dphi = dphi,
                              .d2phi = law->flags & MLAW_HESSIAN ? d2phi : NULL};
  TRY(material_elastic(material, &batch, NULL, error));
  material->shear_modulus = 2.0 * dphi[0];
  material->dilatation_modulus = 4.0 * slope_at_rest(law, dphi, d2phi) - material->shear_modulus;
  TRY(check_rest(material, phi[0], 2.0 * (dphi[0] + dphi[REST_POINTS]), error));
cleanup:
  return status;
}

/* Parameters for batches at one element, or at their means (-1). */
static void view_element(mlaw_field *field, const ParameterValues *values, int element) {
  for (uint32_t k = 0; k < values->n; k++) {
    const bool varies = element >= 0 && values->element[k];
    field[k] = (mlaw_field){varies ? &values->element[k][element] : &values->value[k], 0};
  }
}

static void view_elements(mlaw_field *field, const ParameterValues *values) {
  view_element(field, values, -1);
  for (uint32_t k = 0; k < values->n; k++)
    if (values->element[k]) field[k] = (mlaw_field){values->element[k], 1};
}

/* In every element, if parameters vary; those of their means last, since they stay. */
static Status measure_rest(Material *material, const Mesh *mesh, Error *error) {
  const mlaw_energy *law = material->elastic.energy;
  const ParameterValues *values = &material->elastic_values;
  const double h = REST_STEP, strain[REST_POINTS] = {0.0, -2.0 * h, -h, h, 2.0 * h};
  double *state = NULL;
  Status status;
  TRY(ARRAY_NEW(&state, 2 * REST_POINTS * law->n_vars, error));
  material_start_state(material, LAW_ENERGY, REST_POINTS, REST_POINTS, state);
  for (int e = values->varies ? mesh->n_elements - 1 : -1; e >= -1; e--) {
    view_element(material->elastic_field, values, e);
    status = measure_moduli(material, strain, state, error);
    if (status != STATUS_OK && e >= 0) error_prefix(error, "element %d: ", e);
    TRY(status);
  }
  view_elements(material->elastic_field, values);
cleanup:
  array_free(state);
  return status;
}

/* ---- Set-up ---- */

/* What a material is made from. */
typedef struct {
  const LawSearch *search;
  const LawScales *scales;
  const FieldPlace *place;
  Log *log;
} MaterialSources;

/* One law of the scene: found, and its parameters as values and as what the law is handed. */
static Status take_law(LoadedLaw *law, ParameterValues *values, mlaw_field **field, LawKind kind,
                       const SceneLaw *scene, const MaterialSources *from, Error *error) {
  Status status = law_load(law, kind, scene->law, from->search, error);
  if (status != STATUS_OK) return place_prefix(&scene->place, error);
  const LawDescription table = law_describe(law);
  TRY(ARRAY_NEW(field, table.n_params, error));
  TRY(law_parameters(&table, scene, from->scales, from->place, from->log, values, error));
  if (values->varies && values->n > MAX_VARYING) {
    error_set(error, STATUS_INPUT, "law %s: expected at most %d parameters where one varies, found %u",
              table.id, MAX_VARYING, values->n);
    TRY(place_prefix(&scene->place, error));
  }
  view_elements(*field, values);
cleanup:
  return status;
}

Status material_new(Material *material, const Scene *scene, const LawSearch *search, const LawScales *scales,
                    const FieldPlace *place, Log *log, Error *error) {
  const SceneLaw *elastic = &scene->membrane.elastic, *damage = &scene->membrane.damage;
  Status status;
  /* Without physical values, a quantity with a unit has no meaning. */
  const MaterialSources from = {search, scene->flow.is_physical ? scales : NULL, place, log};
  *material = (Material){.d_max = scene->membrane.d_max, .nonlocal_length = scene->membrane.nonlocal_length};
  TRY(take_law(&material->elastic, &material->elastic_values, &material->elastic_field, LAW_ENERGY, elastic,
               &from, error));
  status = measure_rest(material, place ? place->mesh : NULL, error);
  if (status != STATUS_OK) {
    place_prefix(&elastic->place, error);
    goto cleanup;
  }
  if (damage->law) {
    TRY(take_law(&material->damage, &material->damage_values, &material->damage_field, LAW_DAMAGE, damage,
                 &from, error));
  }
cleanup:
  if (status != STATUS_OK) material_free(material);
  return status;
}

Status material_criterion(Material *material, const Scene *scene, const SceneLaw *law,
                          const LawSearch *search, const LawScales *scales, const FieldPlace *place, Log *log,
                          Error *error) {
  const MaterialSources from = {search, scene->flow.is_physical ? scales : NULL, place, log};
  *material = (Material){.d_max = 1};
  const Status status = take_law(&material->damage, &material->damage_values, &material->damage_field,
                                 LAW_DAMAGE, law, &from, error);
  if (status != STATUS_OK) material_free(material);
  return status;
}

void material_free(Material *material) {
  law_release(&material->elastic);
  law_release(&material->damage);
  parameter_values_free(&material->elastic_values);
  parameter_values_free(&material->damage_values);
  array_free(material->elastic_field);
  array_free(material->damage_field);
  *material = (Material){0};
}

static void keep_values(ParameterValues *values, const int *kept, int n) {
  for (uint32_t k = 0; k < values->n; k++)
    for (int i = 0; values->element[k] && i < n; i++) values->element[k][i] = values->element[k][kept[i]];
}

void material_keep_elements(Material *material, const int *kept, int n) {
  keep_values(&material->elastic_values, kept, n);
  keep_values(&material->damage_values, kept, n);
}

unsigned material_channels(const Material *material) {
  return material_has_damage(material) ? material->damage.damage->needs | 1u << MLAW_Y : 0;
}

bool material_has_damage(const Material *material) {
  return material->damage.damage != NULL;
}

int material_elastic_vars(const Material *material) {
  return (int)material->elastic.energy->n_vars;
}

int material_damage_vars(const Material *material) {
  return material_has_damage(material) ? (int)material->damage.damage->n_vars : 0;
}

void material_start_state(const Material *material, LawKind kind, ptrdiff_t n, ptrdiff_t ld, double *state) {
  const LawDescription law = law_describe(kind == LAW_ENERGY ? &material->elastic : &material->damage);
  for (uint32_t k = 0; k < law.n_vars; k++) {
    for (ptrdiff_t i = 0; i < n; i++) state[(ptrdiff_t)k * ld + i] = law_var(&law, k)->init;
  }
}
