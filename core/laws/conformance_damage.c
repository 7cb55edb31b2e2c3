/* Group `damage`: what any damage law must satisfy.  Irreversibility and caps of explicit laws are the host's
 * work and are not tested here. */
#include "laws/conformance_sample.h"
#include <math.h>
#include <string.h>

enum { POINTS = 48 };

/* ---- Explicit kind: f, zeta, dzeta at given (Y, d) ---- */

enum { F, ZETA, DZETA };

typedef struct {
  double f, zeta, dzeta;
} Explicit;

static Verdict evaluate(const Subject *subject, const Sample *sample, double Y, double d, Explicit *result) {
  Sample point = {.n = 1, .ld = 1, .in = {Y, d}};
  double out[3];
  memcpy(point.value, sample->value, sizeof point.value);
  EXPECT(sample_evaluate(subject, &point, 0.0, out));
  *result = (Explicit){out[F], out[ZETA], out[DZETA]};
  return verdict_passed();
}

/* Runs `test` on every parameter set, with the Y of full damage. */
static Verdict for_each_set(const Subject *subject,
                            Verdict (*test)(const Subject *subject, const Sample *sample, double Y_full)) {
  for (int set = 0; set < PARAMETER_SETS; set++) {
    Sample sample;
    EXPECT(sample_make(subject, set, 1, 1, &sample));
    EXPECT(test(subject, &sample, sample_full_damage(subject, sample.value)));
  }
  return verdict_passed();
}

static Verdict zero_at_start_of(const Subject *subject, const Sample *sample, double Y_full) {
  Explicit at;
  (void)Y_full;
  EXPECT(evaluate(subject, sample, 0.0, 0.0, &at));
  if (at.zeta <= 0.0 && at.f <= 0.0) return verdict_passed();
  return verdict(CONFORMANCE_FAILED,
                 "expected no damage at Y = 0 (zeta <= 0, f <= 0), found zeta = %g, f = %g", at.zeta, at.f);
}

static Verdict monotone_of(const Subject *subject, const Sample *sample, double Y_full) {
  Explicit before, now;
  EXPECT(evaluate(subject, sample, 0.0, 0.0, &before));
  for (int i = 1; i <= 400; i++, before = now) {
    const double Y = 2.0 * Y_full * i / 400.0;
    EXPECT(evaluate(subject, sample, Y, 0.0, &now));
    if (now.zeta >= before.zeta - 1e-14) continue;
    return verdict(CONFORMANCE_FAILED, "expected zeta that never falls with Y, found %g after %g at Y = %g",
                   now.zeta, before.zeta, Y);
  }
  return verdict_passed();
}

/* f(Y; d) < 0 exactly where d is beyond zeta(Y). */
static Verdict signs_agree_of(const Subject *subject, const Sample *sample, double Y_full) {
  for (int i = 0; i <= 60; i++) {
    for (int k = 0; k <= 10; k++) {
      const double Y = 1.5 * Y_full * i / 60.0, d = k / 10.0;
      Explicit at;
      EXPECT(evaluate(subject, sample, Y, d, &at));
      const double margin = 1e-9 * (1.0 + Y_full);
      if (fabs(at.zeta - d) < 1e-9 || fabs(at.f) < margin || (at.f < 0.0) == (at.zeta < d)) continue;
      return verdict(
          CONFORMANCE_FAILED,
          "expected f < 0 exactly where d > zeta(Y), found f = %g with d = %g, zeta = %g at Y = %g", at.f, d,
          at.zeta, Y);
    }
  }
  return verdict_passed();
}

static Verdict consistency_of(const Subject *subject, const Sample *sample, double Y_full) {
  for (int i = 1; i <= 200; i++) {
    const double Y = 1.5 * Y_full * i / 200.0;
    Explicit at, there;
    EXPECT(evaluate(subject, sample, Y, 0.0, &at));
    if (at.zeta <= 0.0 || at.zeta >= 1.0) continue;
    EXPECT(evaluate(subject, sample, Y, at.zeta, &there));
    if (fabs(there.f) <= 1e-10 * (Y + Y_full)) continue;
    return verdict(CONFORMANCE_FAILED, "expected f(Y; zeta(Y)) = 0, found %g at Y = %g, zeta = %g", there.f,
                   Y, at.zeta);
  }
  return verdict_passed();
}

/* Differences of zeta, of order 1, over h are true to 1e-4 of their size, by truncation, and to the rounding
 * of zeta over h. */
static Verdict slope_of(const Subject *subject, const Sample *sample, double Y_full) {
  const double h = 1e-4 * Y_full;
  for (int i = 1; i <= 100; i++) {
    const double Y = 1.3 * Y_full * (i + 0.37) / 100.0;
    Explicit at, plus, minus;
    EXPECT(evaluate(subject, sample, Y, 0.0, &at));
    EXPECT(evaluate(subject, sample, Y + h, 0.0, &plus));
    EXPECT(evaluate(subject, sample, Y - h, 0.0, &minus));
    const double ahead = (plus.zeta - at.zeta) / h, behind = (at.zeta - minus.zeta) / h;
    const double size = fabs(at.dzeta) + fabs(ahead) + fabs(behind);
    if (fabs(ahead - behind) > 1e-2 * size || minus.zeta <= 0.0)
      continue; /* a kink, or below the threshold */
    if (fabs(at.dzeta - 0.5 * (ahead + behind)) <= 1e-4 * size + 1e-15 / h) continue;
    return verdict(CONFORMANCE_FAILED, "expected dzeta = %.8g from differences at Y = %g, found %.8g",
                   0.5 * (ahead + behind), Y, at.dzeta);
  }
  return verdict_passed();
}

static Verdict zero_at_start(const Subject *subject) {
  return for_each_set(subject, zero_at_start_of);
}
static Verdict monotone_in_Ymax(const Subject *subject) {
  return for_each_set(subject, monotone_of);
}
static Verdict silent_below_threshold(const Subject *subject) {
  return for_each_set(subject, signs_agree_of);
}
static Verdict consistency(const Subject *subject) {
  return for_each_set(subject, consistency_of);
}
static Verdict slope_matches_differences(const Subject *subject) {
  return for_each_set(subject, slope_of);
}

/* ---- General kind ---- */

static ptrdiff_t damage_row(const Subject *subject) {
  return kernel_inputs(subject) - 1 - (ptrdiff_t)subject->table.n_vars;
}

/* The host's cap: a law that goes beyond 1, or keeps more than that in its history, is as good as one that
 * caps damage itself. */
static void cap(double *d, ptrdiff_t n) {
  for (ptrdiff_t i = 0; i < n; i++) d[i] = fmin(d[i], 1.0);
}

/* Damage and history of the output become those of the next step's input, as the host does on acceptance. */
static void accept(const Subject *subject, Sample *sample, const double *out) {
  const ptrdiff_t first = damage_row(subject), rows = kernel_outputs(subject);
  memcpy(sample->in + first * sample->ld, out, (size_t)(rows * sample->ld) * sizeof *out);
  cap(sample->in + first * sample->ld, sample->n);
}

static Verdict never_falls(const Subject *subject) {
  for (int set = 0; set < PARAMETER_SETS; set++) {
    Sample sample;
    double out[TABLE];
    EXPECT(sample_make(subject, set, POINTS, POINTS, &sample));
    EXPECT(sample_evaluate(subject, &sample, 0.1, out));
    for (ptrdiff_t i = 0; i < POINTS; i++) {
      const double d0 = sample.in[damage_row(subject) * POINTS + i];
      if (out[i] >= d0) continue;
      return verdict(CONFORMANCE_FAILED,
                     "expected damage that never falls (dissipation >= 0), found %g after %g", out[i], d0);
    }
  }
  return verdict_passed();
}

static Verdict rest_stays_sound(const Subject *subject) {
  for (int set = 0; set < PARAMETER_SETS; set++) {
    Sample sample;
    double out[TABLE];
    EXPECT(sample_make(subject, set, 1, 1, &sample));
    sample_set_channels(subject, &sample, 0, false, 1.0, 1.0);
    sample_set_channels(subject, &sample, 0, true, 1.0, 1.0);
    sample.in[damage_row(subject)] = 0.0;
    EXPECT(sample_evaluate(subject, &sample, 1.0, out));
    if (out[0] == 0.0) continue;
    return verdict(CONFORMANCE_FAILED, "expected a sound membrane at rest to stay sound, found d = %g",
                   out[0]);
  }
  return verdict_passed();
}

/* After a step has been accepted, a step of no length from there to there does nothing. */
static Verdict dt_zero_changes_nothing(const Subject *subject) {
  const ptrdiff_t channels = damage_row(subject) / 2;
  for (int set = 0; set < PARAMETER_SETS; set++) {
    Sample sample;
    double out[TABLE], again[TABLE];
    EXPECT(sample_make(subject, set, POINTS, POINTS, &sample));
    EXPECT(sample_evaluate(subject, &sample, 0.1, out));
    accept(subject, &sample, out);
    memcpy(sample.in, sample.in + channels * POINTS, (size_t)(channels * POINTS) * sizeof *out);
    EXPECT(sample_evaluate(subject, &sample, 0.0, again));
    cap(again, POINTS);
    for (int row = 0; row < kernel_outputs(subject); row++) {
      for (ptrdiff_t i = 0; i < POINTS; i++) {
        const double before = sample.in[(damage_row(subject) + row) * POINTS + i],
                     now = again[row * POINTS + i];
        if (fabs(now - before) <= 1e-13 * (1.0 + fabs(before))) continue;
        return verdict(CONFORMANCE_FAILED, "expected %s to stay %g in a step of no length, found %g",
                       kernel_output_name(subject, row), before, now);
      }
    }
  }
  return verdict_passed();
}

/* The path of one step, walked in `parts` steps; d [POINTS] at its end. */
static Verdict walk(const Subject *subject, const Sample *whole, int parts, double dt, double *d) {
  Sample sample = *whole;
  double out[TABLE];
  const ptrdiff_t channels = damage_row(subject) / 2;
  for (int k = 0; k < parts; k++) {
    for (ptrdiff_t j = 0; j < channels * POINTS; j++) {
      const double from = whole->in[j], to = whole->in[channels * POINTS + j];
      sample.in[j] = from + (to - from) * k / parts;
      sample.in[channels * POINTS + j] = from + (to - from) * (k + 1) / parts;
    }
    EXPECT(sample_evaluate(subject, &sample, dt / parts, out));
    accept(subject, &sample, out);
  }
  memcpy(d, sample.in + damage_row(subject) * POINTS, POINTS * sizeof *d);
  return verdict_passed();
}

/* A law that does not depend on rate gives the same however a monotone path is cut; any other must come
 * together as the parts get smaller, at first order or better. */
static Verdict step_split(const Subject *subject) {
  for (int set = 0; set < PARAMETER_SETS; set++) {
    Sample sample;
    double d[3][POINTS], coarse = 0.0, fine = 0.0;
    EXPECT(sample_make(subject, set, POINTS, POINTS, &sample));
    for (int k = 0; k < 3; k++) EXPECT(walk(subject, &sample, 32 << k, 0.1, d[k]));
    for (int i = 0; i < POINTS; i++) {
      coarse = fmax(coarse, fabs(d[1][i] - d[0][i]));
      fine = fmax(fine, fabs(d[2][i] - d[1][i]));
    }
    if (fine <= 0.7 * coarse + 1e-12) continue;
    return verdict(
        CONFORMANCE_FAILED,
        "expected damage that converges as steps get smaller, found changes of %g from 32 to 64 steps "
        "and of %g from 64 to 128",
        coarse, fine);
  }
  return verdict_passed();
}

static const ConformanceTest tests[] = {
    {FOR_EXPLICIT, "zero-at-start", "no damage at Y = 0", zero_at_start},
    {FOR_EXPLICIT, "monotone-in-Ymax", "zeta never falls with Y", monotone_in_Ymax},
    {FOR_EXPLICIT, "silent-below-threshold", "f is negative where damage cannot grow",
     silent_below_threshold},
    {FOR_EXPLICIT, "consistency", "f(Y; zeta(Y)) = 0", consistency},
    {FOR_EXPLICIT, "slope-matches-differences", "dzeta is the slope of zeta", slope_matches_differences},
    {FOR_GENERAL, "never-falls", "damage never falls: dissipation >= 0", never_falls},
    {FOR_GENERAL, "rest-stays-sound", "a sound membrane at rest stays sound", rest_stays_sound},
    {FOR_GENERAL, "dt-zero-changes-nothing", "a step of no length changes nothing", dt_zero_changes_nothing},
    {FOR_GENERAL, "step-split", "damage converges as a step is cut", step_split},
};

const ConformanceGroup conformance_damage = {"damage", tests, sizeof tests / sizeof *tests};
