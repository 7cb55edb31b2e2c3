#include "membrane/observer.h"

#include "base/array.h"
#include <string.h>

static size_t state_size(const Material *law, size_t points) {
  return (size_t)material_damage_vars(law) * points;
}

/* Lays channels and histories out in one block of memory. */
static void lay_out(const Observers *o, double *memory, double **channel, ObserverHistory *history) {
  const size_t points = (size_t)membrane_points(o->membrane);
  double *next = memory;
  for (int c = 0; c < MLAW_N_CHANNELS; c++) {
    if (!(o->channels & 1u << c)) continue;
    channel[c] = next;
    next += points;
  }
  for (size_t i = 0; i < o->n; i++) {
    history[i] = (ObserverHistory){.Ymax = next, .d = next + points};
    next += 2 * points;
    if (state_size(&o->law[i], points) > 0) history[i].state = next;
    next += state_size(&o->law[i], points);
  }
}

static size_t measure(const Observers *o) {
  const size_t points = (size_t)membrane_points(o->membrane);
  size_t size = 0;
  for (int c = 0; c < MLAW_N_CHANNELS; c++) size += o->channels & 1u << c ? points : 0;
  for (size_t i = 0; i < o->n; i++) size += 2 * points + state_size(&o->law[i], points);
  return size;
}

/* A sound membrane at rest. */
static void start(Observers *o) {
  const int points = membrane_points(o->membrane);
  for (int c = MLAW_L1; c <= MLAW_L2; c++)
    for (int k = 0; o->channel0[c] && k < points; k++) o->channel0[c][k] = 1;
  for (size_t i = 0; i < o->n; i++)
    if (o->history0[i].state)
      material_start_state(&o->law[i], LAW_DAMAGE, points, points, o->history0[i].state);
}

Status observers_new(Observers *o, const Membrane *membrane, const Material *law, size_t n, Error *error) {
  Status status = STATUS_OK;
  *o = (Observers){.law = law, .n = n, .membrane = membrane};
  for (size_t i = 0; i < n; i++) o->channels |= material_channels(&law[i]);
  o->size = measure(o);
  TRY(ARRAY_NEW(&o->accepted, o->size, error));
  TRY(ARRAY_NEW(&o->trial, o->size, error));
  TRY(ARRAY_NEW(&o->history0, n, error));
  TRY(ARRAY_NEW(&o->history, n, error));
  lay_out(o, o->accepted, o->channel0, o->history0);
  lay_out(o, o->trial, o->channel, o->history);
  start(o);
cleanup:
  if (status != STATUS_OK) observers_free(o);
  return status;
}

void observers_free(Observers *o) {
  array_free(o->accepted);
  array_free(o->trial);
  array_free(o->history0);
  array_free(o->history);
  *o = (Observers){0};
}

void observers_read(Observers *o) {
  membrane_channels(o->membrane, o->channel);
}

/* The points at rule point g of every element: one value of a parameter that varies for each. */
static Status step_range(Observers *o, size_t i, int g, double t, double dt, Error *error) {
  const ObserverHistory *old = &o->history0[i], *new = &o->history[i];
  const int points = membrane_points(o->membrane), n = points / POINTS_PER_ELEMENT, k = g * n;
  DamageBatch batch = {
      .n = n,
      .ld = points,
      .t = t,
      .dt = dt,
      .Ymax0 = old->Ymax + k,
      .d0 = old->d + k,
      .state0 = old->state ? old->state + k : NULL,
      .Ymax1 = new->Ymax + k,
      .d1 = new->d + k,
      .state1 = new->state ? new->state + k : NULL,
  };
  for (int c = 0; c < MLAW_N_CHANNELS; c++) {
    batch.chan0[c] = o->channel0[c] ? o->channel0[c] + k : NULL;
    batch.chan[c] = o->channel[c] ? o->channel[c] + k : NULL;
  }
  return material_damage(&o->law[i], &batch, NULL, error);
}

Status observers_step(Observers *o, size_t i, double t, double dt, Error *error) {
  Status status = STATUS_OK;
  for (int g = 0; g < POINTS_PER_ELEMENT && status == STATUS_OK; g++)
    status = step_range(o, i, g, t, dt, error);
  if (status == STATUS_REJECT) status = error->code = STATUS_FAILED;
  return status;
}

void observers_commit(Observers *o) {
  memcpy(o->accepted, o->trial, o->size * sizeof *o->accepted);
}
