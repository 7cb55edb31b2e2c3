/* What a run has seen so far, and the measures of its state: energies, extremes, first damage, rupture.
 *
 * A record is looked after by the loop: `record_probe` puts the membrane's trial state at a time inside the
 * proposed step, measures read it, `record_advance` takes the end of the step in. */
#ifndef CAPSELLA_RUN_RECORD_H
#define CAPSELLA_RUN_RECORD_H

#include "base/status.h"
#include "mesh/contact.h"
#include "observe/history.h"
#include "observe/shape.h"
#include "observe/summary.h"
#include "observe/wrinkles.h"
#include "run/balance.h"
#include "run/criteria.h"
#include "run/simulation.h"

/* Everything here is a double, so that a restart keeps it as one array. */
typedef struct {
  double t_c, t_l; /* NAN: not yet */
  double Y_max;    /* largest Y of any integration point so far (paper eq. 2.31) */
  double volume_error_max, energy_error_max;
  double work, dissipated; /* up to the accepted time, in units of G_s a^2 */
  double energy_scale;     /* the largest of work and energy spent so far: what the error of the balance is
                              relative to */
  Site rupture;            /* once t_l is known */
  double rupture_area;
  double steady_since; /* start of the time over which rates stayed below stop.steady; NAN: not now */
  double sample_t, sample_D12, sample_d_max; /* of the last sample */
  double wall_seconds;                       /* of earlier processes of this run */
  /* Thinnest film between two parts of the membrane, in widths of the elements there (mesh/contact.h); NAN:
   * none thinner than an element is wide. */
  double film_min;
  double contact_due;            /* evaluations at which it is looked for again */
  double wrinkle_max, wrinkle_t; /* largest wrinkle_amplitude of a row, and its time */
} RecordData;

struct Record {
  Simulation *simulation;
  RecordData data;
  Criteria criteria;
  ContactSearch *contact; /* NULL, as the wrinkles: no fluid moves the membrane */
  Wrinkles *wrinkles;
  double probed_t;            /* time of the membrane's trial state; NAN: not in the proposed step */
  double *x, *v, *R;          /* [n_nodes][3] at the probed time */
  double *gradient;           /* [n_nodes][3] of the elastic energy at the probed time, as R on a quadratic
                                 membrane */
  double *gradient0;          /* the same at the accepted time */
  double stored0;             /* elastic energy there, in the units of the law */
  Balance balance;            /* of the proposed step */
  double *T1, *T2;            /* [n_points] scratch */
  double *area_vector, *load; /* [n_nodes][3] scratch of an inflation, NULL otherwise */
  double t1;                  /* end of the proposed step */
};

Status record_new(Record *record, Simulation *simulation, Error *error);
void record_free(Record *record);

/* The simulation stands at its start, or has been restored from a snapshot (`data` then too). */
Status record_begin(Record *record, bool restored, Error *error);

/* A step from the accepted time to t1 has been proposed (or made shorter): takes its energy balance and
 * leaves the probe at t1. */
Status record_step(Record *record, double t1, Error *error);

/* Puts x, v, R and the membrane's trial state at time t of the proposed step. */
Status record_probe(Record *record, double t, Error *error);

/* One row at the probed time. */
Status record_row(Record *record, HistoryRow *row, Shape *shape, Error *error);

/* The shape at the probed time; for an inflation the vorticity axis is taken as e_y. */
Status record_shape(const Record *record, Shape *shape, Error *error);

/* Where integration point k is at the probed time, which has this shape. */
Site record_site(const Record *record, const Shape *shape, int k);

/* The first time in the proposed step at which `happened` says so, found by bisection between its ends (it
 * does at t1); the probe is left there. */
typedef Status RecordTest(Record *record, const void *context, bool *happened, Error *error);
Status record_locate(Record *record, RecordTest *happened, const void *context, double *t, Error *error);

/* First damage and rupture inside the proposed step, located on the dense output; sets t_c, t_l when they
 * occur. */
Status record_events(Record *record, Error *error);

/* Takes the end of the proposed step in: work, dissipation, extremes.  Call with the probe at t1, before the
 * membrane commits. */
Status record_advance(Record *record, Error *error);

/* Where d (or, without a damage law, Y) is largest at the probed time: reference and current position. */
void record_peak(const Record *record, double X[3], double x[3]);

/* Fills in the figures of the summary at the probed time; the caller adds outcome, steps and cost. */
Status record_summary(Record *record, Summary *summary, Error *error);

#endif
