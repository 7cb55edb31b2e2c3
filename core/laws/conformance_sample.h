/* Parameters and states that a law must be able to take, drawn the same way in every run. */
#ifndef CAPSELLA_LAWS_CONFORMANCE_SAMPLE_H
#define CAPSELLA_LAWS_CONFORMANCE_SAMPLE_H

#include "laws/conformance_kernel.h"

enum { PARAMETER_SETS = 4 };

typedef struct {
  ptrdiff_t n, ld;
  double value[MAX_PARAMS]; /* parameters */
  double in[TABLE];         /* [kernel_inputs][ld] */
} Sample;

/* Set 0 has the defaults (the middle of the calibrated range where there are none), the others are drawn from
 * the calibrated range.  Energy laws get points that they accept, with principal stretches within 0.6 .. 1.8
 * that differ by 0.1 or more; explicit damage laws Y from 0 to beyond full damage and d in 0 .. 1; general
 * ones a path of a membrane between two strains.  CONFORMANCE_FAILED when the law accepts nothing. */
Verdict sample_make(const Subject *subject, int set, ptrdiff_t n, ptrdiff_t ld, Sample *sample);

/* Set 0 in states next to rest, made without calling the law. */
Verdict sample_make_mild(const Subject *subject, ptrdiff_t n, ptrdiff_t ld, Sample *sample);

/* Strains of principal stretches l1, l2 in column i of an energy law's table. */
void sample_set_strain(Sample *sample, ptrdiff_t i, double l1, double l2);

/* Y at which an explicit law comes to full damage, to a factor of two; where it never does, some Y beyond the
 * threshold. */
double sample_full_damage(const Subject *subject, const double *value);

/* Row r of point i of a membrane at principal stretches l1, l2 (of modulus 1), for a general damage law. */
void sample_set_channels(const Subject *subject, Sample *sample, ptrdiff_t i, bool at_end, double l1,
                         double l2);

/* Calls the law on the whole sample with uniform parameters; `out` is [kernel_outputs][ld].
 * CONFORMANCE_FAILED when it refuses. */
Verdict sample_evaluate(const Subject *subject, const Sample *sample, double dt, double *out);

#endif
