#include "run/march.h"

#include "run/contact_guard.h"

#include <math.h>

/* A run is steady when its rates have stayed below stop.steady for this long. */
static const double STEADY_TIME = 1.0;

Status march_renew_load(Record *record, double t, Error *error) {
  Status status = STATUS_OK;
  const Simulation *s = record->simulation;
  TRY(record_probe(record, t, error));
  TRY(membrane_load(s->membrane, LOAD_FULL, record->R, s->motion->q, error));
cleanup:
  return status;
}

Status march_fall_back(Record *record, Error *error) {
  record->probed_t = NAN;
  record->t1 = record->simulation->motion->t;
  return march_renew_load(record, record->t1, error);
}

/* Ends the proposed step at the instant of rupture. */
static Status stop_at_rupture(Record *record, Error *error) {
  Status status = STATUS_OK;
  Motion *motion = record->simulation->motion;
  const double t_l = record->data.t_l;
  motion->shorten(motion, t_l);
  TRY(record_step(record, t_l, error));
  TRY(march_renew_load(record, t_l, error));
cleanup:
  return status;
}

Status march_propose(Record *record, double t_limit, Log *log, bool *ruptured, Error *error) {
  Status status = STATUS_OK;
  Simulation *s = record->simulation;
  double t1;
  *ruptured = false;
  TRY(s->motion->propose(s->motion, t_limit, &t1, log, error));
  TRY(record_step(record, t1, error));

  const bool was_whole = isnan(record->data.t_l);
  TRY(record_events(record, error));
  TRY(contact_guard(record, log, error));
  if (!was_whole || isnan(record->data.t_l)) goto cleanup;
  log_note(log, "rupture at t = %.6g", record->data.t_l);
  *ruptured = s->scene->stop.rupture == RUPTURE_STOP;
  if (*ruptured) TRY(stop_at_rupture(record, error));
cleanup:
  return status;
}

Status march_accept(Record *record, Error *error) {
  Status status = STATUS_OK;
  const Simulation *s = record->simulation;
  TRY(record_advance(record, error));
  s->motion->accept(s->motion);
  membrane_commit(s->membrane);
cleanup:
  return status;
}

void march_watch_steady(Record *record, const HistoryRow *row) {
  RecordData *data = &record->data;
  const double limit = record->simulation->scene->stop.steady, dt = row->t - data->sample_t;
  if (dt > 0) {
    const double rate = fmax(fabs(row->D12 - data->sample_D12), fabs(row->d_max - data->sample_d_max)) / dt;
    if (!(rate < limit))
      data->steady_since = NAN;
    else if (isnan(data->steady_since))
      data->steady_since = data->sample_t;
  }
  data->sample_t = row->t;
  data->sample_D12 = row->D12;
  data->sample_d_max = row->d_max;
}

void march_watch_wrinkles(Record *record, const HistoryRow *row) {
  RecordData *data = &record->data;
  if (row->wrinkle_amplitude <= data->wrinkle_max) return;
  data->wrinkle_max = row->wrinkle_amplitude;
  data->wrinkle_t = row->t;
}

bool march_is_steady(const Record *record) {
  return record->simulation->scene->stop.steady > 0 &&
         record->data.sample_t - record->data.steady_since >= STEADY_TIME;
}
