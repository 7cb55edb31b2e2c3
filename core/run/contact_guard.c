#include "run/contact_guard.h"

#include <math.h>

/* Evaluations of the velocity from one look to the next: a look costs 5 % of one at most on a capsule without
 * contact, and a step of an adaptive run has about as many. */
static const double EVERY = 16;

/* Widths of an element.  Below THIN the flow in the film, which must push its fluid out past the elements on
 * both sides, is not that of the capsule but of the mesh, and what the direct method leaves of the kernel's
 * peak exceeds 1e-3.  Below TOUCHING nothing holds the sheets apart but errors. */
static const double THIN = 0.5, TOUCHING = 0.02;

static const char *advice(Simulation *s) {
  if (s->scene->fluid_method == FLUID_DIRECT) return ", nor does `fluid.method: direct`; write `fast`";
  return system_sum_in_full(&s->system) ? "; inner stages of a step are summed in full from now on" : "";
}

static void warn(const Record *record, const Contact *contact, Log *log) {
  log_warning(
      log,
      "at t = %.6g two parts of the membrane are %.3g a apart near (%.3f, %.3f, %.3f), %.2g of the width "
      "of the elements there: the mesh does not resolve the flow between them%s",
      record->t1, contact->gap, contact->place[0], contact->place[1], contact->place[2], contact->share,
      advice(record->simulation));
}

static Status stop(const Record *record, const Contact *contact, Error *error) {
  return error_set(
      error, STATUS_FAILED,
      "the membrane %s itself at t = %.6g near (%.3f, %.3f, %.3f): expected a film between its two "
      "parts of at least %g of the width of the elements there, found %s%.2g",
      contact->crosses ? "crosses" : "touches", record->t1, contact->place[0], contact->place[1],
      contact->place[2], TOUCHING, contact->crosses ? "-" : "", contact->share);
}

void contact_guard_resume(Record *record) {
  if (record->data.film_min < THIN) system_sum_in_full(&record->simulation->system);
}

Status contact_guard(Record *record, Log *log, Error *error) {
  Status status = STATUS_OK;
  const Simulation *s = record->simulation;
  RecordData *data = &record->data;
  const double evaluations = (double)s->motion->evaluations(s->motion);
  const bool is_due = evaluations >= data->contact_due || record->t1 >= s->scene->time.end;
  if (!record->contact || !is_due) return STATUS_OK;
  TRY(record_probe(record, record->t1, error));
  const Contact contact = contact_find(record->contact, record->x);
  data->contact_due = evaluations + EVERY;
  if (contact.crosses || contact.share < TOUCHING) TRY(stop(record, &contact, error));
  if (contact.share < THIN && !(data->film_min < THIN)) warn(record, &contact, log);
  if (contact.share < 1) data->film_min = fmin(data->film_min, contact.share);
cleanup:
  return status;
}
