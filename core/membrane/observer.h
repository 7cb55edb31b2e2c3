/* Damage laws that look on: each sees the motion of the membrane and keeps a damage of its own, which the
 * membrane does not feel.
 *
 * As with the membrane, trial and accepted damage are apart: observers_step writes the trial,
 * observers_commit accepts it.  What is read is shared by all, so that one more law costs one more call. */
#ifndef CAPSELLA_MEMBRANE_OBSERVER_H
#define CAPSELLA_MEMBRANE_OBSERVER_H

#include "base/status.h"
#include "laws/material.h"
#include "membrane/membrane.h"
#include <stddef.h>

/* Views into the memory of all: [n_points], state [n_vars][n_points] or NULL. */
typedef struct {
  double *Ymax, *d, *state;
} ObserverHistory;

typedef struct {
  const Material *law; /* [n] made by material_criterion */
  size_t n;
  const Membrane *membrane;
  unsigned channels;        /* what the laws read, bit mask */
  double *accepted, *trial; /* [size] channels and histories; `accepted` is what a restart needs */
  size_t size;
  double *channel0[MLAW_N_CHANNELS], *channel[MLAW_N_CHANNELS]; /* [n_points] views of the two */
  ObserverHistory *history0, *history;                          /* [n] the same */
} Observers;

/* `law` and `membrane` must outlive the observers. */
Status observers_new(Observers *observers, const Membrane *membrane, const Material *law, size_t n,
                     Error *error);
void observers_free(Observers *observers);

/* Reads the membrane's last evaluation. */
void observers_read(Observers *observers);

/* Trial damage of law i, history[i].d, at the state last read, t + dt, where t is the time of the accepted
 * one.  A law that refuses it ends in STATUS_FAILED: what looks on cannot ask for a smaller step. */
Status observers_step(Observers *observers, size_t i, double t, double dt, Error *error);

/* Accepts the trial state of all laws. */
void observers_commit(Observers *observers);

#endif
