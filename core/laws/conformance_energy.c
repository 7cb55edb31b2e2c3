/* Group `energy`: what any elastic membrane must satisfy. */
#include "laws/conformance_sample.h"
#include <math.h>

enum { POINTS = 24 };
enum { PHI, PHI_1, PHI_2, PHI_11, PHI_12, PHI_22 };

static bool has_hessian(const Subject *subject) {
  return subject->energy->flags & MLAW_HESSIAN;
}

/* One point at (I1, I2) with the history at its start; false when the law refuses it. */
static bool evaluate(const Subject *subject, const Sample *sample, double I1, double I2,
                     double out[MAX_ROWS]) {
  double in[MAX_ROWS] = {I1, I2};
  mlaw_field field[MAX_PARAMS];
  for (uint32_t k = 0; k < subject->table.n_vars; k++) in[2 + k] = law_var(&subject->table, k)->init;
  kernel_fields(subject, sample->value, field);
  KernelCall call = {.n = 1, .ld = 1, .param = field, .in = in, .out = out, .without = -1};
  return kernel_call(subject, &call) == MLAW_OK;
}

static Verdict at_rest(const Subject *subject, int set, Sample *sample, double out[MAX_ROWS]) {
  EXPECT(sample_make(subject, set, 1, 1, sample));
  if (evaluate(subject, sample, 0.0, 0.0, out)) return verdict_passed();
  return verdict(CONFORMANCE_FAILED, "expected the law to take the state at rest, found that it refuses");
}

static Verdict zero_at_rest(const Subject *subject) {
  for (int set = 0; set < PARAMETER_SETS; set++) {
    Sample sample;
    double out[MAX_ROWS];
    EXPECT(at_rest(subject, set, &sample, out));
    if (fabs(out[PHI]) <= 1e-12 * fabs(out[PHI_1])) continue;
    return verdict(CONFORMANCE_FAILED, "expected phi = 0 at rest, found %g", out[PHI]);
  }
  return verdict_passed();
}

static Verdict no_tension_at_rest(const Subject *subject) {
  for (int set = 0; set < PARAMETER_SETS; set++) {
    Sample sample;
    double out[MAX_ROWS];
    EXPECT(at_rest(subject, set, &sample, out));
    if (fabs(out[PHI_1] + out[PHI_2]) <= 1e-12 * fabs(out[PHI_1])) continue;
    return verdict(CONFORMANCE_FAILED, "expected phi_1 + phi_2 = 0 at rest, found %g",
                   out[PHI_1] + out[PHI_2]);
  }
  return verdict_passed();
}

/* ---- Derivatives against differences ---- */

/* Points are admissible to all sides at this distance: stretches differ by 0.1 or so, hence I1 exceeds its
 * least value by 0.01. */
static const double STEP = 1e-3;

/* Differences at +-h and +-h/2, combined: error of fourth order.  Rounding leaves 1e-13 of the values, the
 * truncation 1e-12 times a fifth derivative. */
static const double TOLERANCE = 1e-7;

/* Column i: derivatives of output rows 0 .. 2 in direction 0 (I1) or 1 (I2); false when the law refuses a
 * point nearby. */
static bool differentiate(const Subject *subject, const Sample *sample, ptrdiff_t i, int direction,
                          double d[3]) {
  static const double shift[4] = {1.0, -1.0, 0.5, -0.5};
  double value[4][MAX_ROWS];
  for (int k = 0; k < 4; k++) {
    const double s = shift[k] * STEP;
    if (!evaluate(subject, sample, sample->in[i] + (direction == 0 ? s : 0.0),
                  sample->in[sample->ld + i] + (direction == 1 ? s : 0.0), value[k])) {
      return false;
    }
  }
  for (int row = 0; row < 3; row++) {
    const double wide = (value[0][row] - value[1][row]) / (2.0 * STEP);
    const double narrow = (value[2][row] - value[3][row]) / STEP;
    d[row] = (4.0 * narrow - wide) / 3.0;
  }
  return true;
}

/* Rows `first` .. of the law's derivatives against differences of rows below. */
static Verdict compare_derivatives(const Subject *subject, bool second) {
  for (int set = 0; set < PARAMETER_SETS; set++) {
    Sample sample;
    EXPECT(sample_make(subject, set, POINTS, POINTS, &sample));
    for (ptrdiff_t i = 0; i < POINTS; i++) {
      double out[MAX_ROWS], d[2][3];
      if (!evaluate(subject, &sample, sample.in[i], sample.in[POINTS + i], out)) continue;
      if (!differentiate(subject, &sample, i, 0, d[0]) || !differentiate(subject, &sample, i, 1, d[1]))
        continue;
      const double found[3] = {out[second ? PHI_11 : PHI_1], out[second ? PHI_12 : PHI_2], out[PHI_22]};
      const double expected[3] = {d[0][second ? PHI_1 : PHI], d[1][second ? PHI_1 : PHI], d[1][PHI_2]};
      const double size = 1.0 + fabs(out[PHI]) + fabs(out[PHI_1]) + fabs(out[PHI_2]) + fabs(expected[0]) +
                          fabs(expected[1]) + (second ? fabs(expected[2]) : 0.0);
      if (!isfinite(size)) continue; /* which finite-on-range says better */
      for (int k = 0; k < (second ? 3 : 2); k++) {
        if (fabs(found[k] - expected[k]) <= TOLERANCE * size) continue;
        return verdict(CONFORMANCE_FAILED,
                       "expected %s = %.10g from differences at I1 = %g, I2 = %g, found %.10g",
                       kernel_output_name(subject, second ? PHI_11 + k : PHI_1 + k), expected[k],
                       sample.in[i], sample.in[POINTS + i], found[k]);
      }
    }
  }
  return verdict_passed();
}

static Verdict gradient_matches_differences(const Subject *subject) {
  return compare_derivatives(subject, false);
}

static Verdict hessian_matches_differences(const Subject *subject) {
  if (has_hessian(subject)) return compare_derivatives(subject, true);
  return verdict(CONFORMANCE_SKIPPED, "the law gives no second derivatives");
}

/* ---- Moduli and range ---- */

/* phi_11 + 2 phi_12 + phi_22 at rest: the slope of phi_1 + phi_2 along (s, s). */
static bool slope_at_rest(const Subject *subject, const Sample *sample, double *slope) {
  static const double shift[4] = {1.0, -1.0, 0.5, -0.5};
  double g[4], out[MAX_ROWS];
  for (int k = 0; k < 4; k++) {
    if (!evaluate(subject, sample, shift[k] * STEP, shift[k] * STEP, out)) return false;
    g[k] = out[PHI_1] + out[PHI_2];
  }
  *slope = (8.0 * (g[2] - g[3]) - (g[0] - g[1])) / (6.0 * STEP);
  return true;
}

static Verdict positive_moduli(const Subject *subject) {
  double G0 = 0.0, K0 = 0.0;
  for (int set = 0; set < PARAMETER_SETS; set++) {
    Sample sample;
    double out[MAX_ROWS], slope;
    EXPECT(at_rest(subject, set, &sample, out));
    if (!slope_at_rest(subject, &sample, &slope)) {
      return verdict(CONFORMANCE_FAILED,
                     "expected the law to take strains of 0.001 about rest, found a refusal");
    }
    const double G = 2.0 * out[PHI_1], K = 4.0 * slope - G;
    if (set == 0) {
      G0 = G;
      K0 = K;
    }
    if (G > 0.0 && K > 0.0) continue;
    return verdict(CONFORMANCE_FAILED, "expected positive moduli at rest, found G_s = %g, K_s = %g", G, K);
  }
  return verdict(CONFORMANCE_PASSED, "G_s = %.6g, K_s = %.6g", G0, K0);
}

/* From strong compression to strong extension, equal stretches among them: finite or refused. */
static Verdict finite_on_range(const Subject *subject) {
  for (int set = 0; set < PARAMETER_SETS; set++) {
    Sample sample;
    EXPECT(sample_make(subject, set, 1, 1, &sample));
    for (double l1 = 0.4; l1 < 3.05; l1 += 0.1) {
      for (double l2 = 0.4; l2 <= l1; l2 += 0.1) {
        double out[MAX_ROWS];
        sample_set_strain(&sample, 0, l1, l2);
        if (!evaluate(subject, &sample, sample.in[0], sample.in[1], out)) continue;
        for (int row = 0; row < kernel_outputs(subject); row++) {
          if (isfinite(out[row])) continue;
          return verdict(CONFORMANCE_FAILED,
                         "expected a finite %s at stretches %g and %g (or a refusal), found %g",
                         kernel_output_name(subject, row), l1, l2, out[row]);
        }
      }
    }
  }
  return verdict_passed();
}

static const ConformanceTest tests[] = {
    {FOR_ENERGY, "zero-at-rest", "no energy at rest", zero_at_rest},
    {FOR_ENERGY, "no-tension-at-rest", "no tension at rest", no_tension_at_rest},
    {FOR_ENERGY, "gradient-matches-differences", "first derivatives are those of phi",
     gradient_matches_differences},
    {FOR_ENERGY, "hessian-matches-differences", "second derivatives are those of the first",
     hessian_matches_differences},
    {FOR_ENERGY, "positive-moduli", "G_s and K_s at rest are those of a stable membrane", positive_moduli},
    {FOR_ENERGY, "finite-on-range", "results are finite wherever the law does not refuse", finite_on_range},
};

const ConformanceGroup conformance_energy = {"energy", tests, sizeof tests / sizeof *tests};
