#include "run/criteria.h"

#include "base/array.h"
#include "run/record.h"
#include <math.h>

Status criteria_new(Criteria *criteria, const Simulation *s, Error *error) {
  Status status = STATUS_OK;
  *criteria = (Criteria){0};
  if (s->n_criteria == 0) return STATUS_OK;
  TRY(observers_new(&criteria->observers, s->membrane, s->criterion, s->n_criteria, error));
  TRY(ARRAY_NEW(&criteria->finding, s->n_criteria, error));
  for (size_t i = 0; i < s->n_criteria; i++) criteria->finding[i] = (Finding){.t_c = NAN, .t_l = NAN};
cleanup:
  if (status != STATUS_OK) criteria_free(criteria);
  return status;
}

void criteria_free(Criteria *criteria) {
  observers_free(&criteria->observers);
  array_free(criteria->finding);
  *criteria = (Criteria){0};
}

/* ---- evaluation ---- */

static double largest_damage(const Criteria *criteria, size_t i) {
  const Observers *o = &criteria->observers;
  const double *d = o->history[i].d;
  return d[membrane_largest(o->membrane, d)];
}

/* Trial damage of criterion i at the probed time; the channels have been read. */
static Status step_one(Record *record, size_t i, Error *error) {
  const Simulation *s = record->simulation;
  const double t0 = s->motion->t;
  const Status status = observers_step(&record->criteria.observers, i, t0, record->probed_t - t0, error);
  if (status == STATUS_OK) return STATUS_OK;
  return error_prefix(error, "criterion %s: ", s->scene->observe.criteria[i].name);
}

static Status step_all(Record *record, double t, Error *error) {
  Status status = STATUS_OK;
  Criteria *criteria = &record->criteria;
  TRY(record_probe(record, t, error));
  observers_read(&criteria->observers);
  for (size_t i = 0; i < criteria->observers.n; i++) TRY(step_one(record, i, error));
cleanup:
  return status;
}

Status criteria_begin(Record *record, Error *error) {
  if (record->criteria.observers.n == 0 || !simulation_is_inflation(record->simulation)) return STATUS_OK;
  const Status status = step_all(record, record->simulation->motion->t, error);
  if (status == STATUS_OK) observers_commit(&record->criteria.observers);
  return status;
}

/* ---- events ---- */

typedef struct {
  size_t i;
  double level; /* 0: d > 0 */
} Event;

static Status has_happened(Record *record, const void *context, bool *answer, Error *error) {
  const Event *event = context;
  observers_read(&record->criteria.observers);
  const Status status = step_one(record, event->i, error);
  const double d = largest_damage(&record->criteria, event->i);
  *answer = event->level > 0 ? d >= event->level : d > 0;
  return status;
}

static Status locate(Record *record, size_t i, double level, double *t, Error *error) {
  const Event event = {i, level};
  Status status = STATUS_OK;
  bool ignored;
  TRY(record_locate(record, has_happened, &event, t, error));
  TRY(has_happened(record, &event, &ignored, error)); /* the trial damage at that time */
cleanup:
  return status;
}

/* What the membrane looks like at the probed time to a criterion with damage d. */
static Status look(Record *record, const double *d, Finding *finding, Error *error) {
  Status status = STATUS_OK;
  const Membrane *membrane = record->simulation->membrane;
  const MembranePoints points = membrane_points_view(membrane);
  Shape shape;
  TRY(record_shape(record, &shape, error));
  const int worst = membrane_largest(membrane, d), thinnest = membrane_largest(membrane, points.J);
  membrane_principal_tensions(membrane, record->T1, record->T2);
  const int tensest = membrane_largest(membrane, record->T1);
  finding->t = record->probed_t;
  finding->d_max = d[worst];
  finding->site = record_site(record, &shape, worst);
  finding->damaged_area_fraction = membrane_damaged_area(membrane, d);
  finding->thickness_min = 1 / points.J[thinnest];
  finding->thinnest = record_site(record, &shape, thinnest);
  finding->T1_max = record->T1[tensest] / record->simulation->material.shear_modulus;
  finding->tensest = record_site(record, &shape, tensest);
cleanup:
  return status;
}

Status criteria_advance(Record *record, Error *error) {
  Status status = STATUS_OK;
  Criteria *criteria = &record->criteria;
  if (criteria->observers.n == 0) return STATUS_OK;
  TRY(step_all(record, record->t1, error));
  for (size_t i = 0; i < criteria->observers.n; i++) {
    Finding *finding = &criteria->finding[i];
    const double d = largest_damage(criteria, i); /* at t1 */
    if (isnan(finding->t_c) && d > 0) TRY(locate(record, i, 0, &finding->t_c, error));
    if (isnan(finding->t_l) && d >= 1) {
      TRY(locate(record, i, 1, &finding->t_l, error));
      TRY(look(record, criteria->observers.history[i].d, finding, error));
    }
  }
  if (record->probed_t != record->t1) TRY(step_all(record, record->t1, error));
  observers_commit(&criteria->observers);
cleanup:
  return status;
}

/* ---- verdicts ---- */

Status criteria_verdicts(Record *record, Verdict *verdicts, Error *error) {
  Status status = STATUS_OK;
  const Simulation *s = record->simulation;
  const Criteria *criteria = &record->criteria;
  for (size_t i = 0; i < criteria->observers.n; i++) {
    verdicts[i] = (Verdict){.name = s->scene->observe.criteria[i].name,
                            .law = s->criterion[i].damage.damage->id,
                            .finding = criteria->finding[i]};
    if (isnan(criteria->finding[i].t_l))
      TRY(look(record, criteria->observers.history0[i].d, &verdicts[i].finding, error));
  }
cleanup:
  return status;
}
