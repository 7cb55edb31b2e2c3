/* Drawing of samples. */
#include "laws/conformance_sample.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* Uniform in 0 .. 1 (splitmix64). */
static double draw(uint64_t *state) {
  uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* ---- Parameters ---- */

/* A point of the calibrated range; one without end is taken as some multiples of the default long. */
static double within(const mlaw_param *param, double fraction) {
  const double size = fmax(1.0, fabs(param->flags & MLAW_REQUIRED ? 0.0 : param->value));
  double lo = param->ok_lo, hi = param->ok_hi;
  if (!isfinite(lo)) lo = isfinite(hi) ? hi - 2.0 * size : -size;
  if (hi > lo + 4.0 * size) hi = lo + 2.0 * size;
  return lo + fraction * (hi - lo);
}

static bool law_accepts(const Subject *subject, const double *value) {
  mlaw_error err = {.point = -1};
  return !subject->table.check || subject->table.check(value, &err) == MLAW_OK;
}

static bool draw_parameters(const Subject *subject, int set, uint64_t *state, double *value) {
  for (int attempt = 0; attempt < 500; attempt++) {
    for (uint32_t k = 0; k < subject->table.n_params; k++) {
      const mlaw_param *param = law_param(&subject->table, k);
      const bool plain = set == 0 && attempt == 0;
      if (plain && !(param->flags & MLAW_REQUIRED)) {
        value[k] = param->value;
      } else {
        value[k] = within(param, plain ? 0.5 : 0.05 + 0.9 * draw(state));
      }
    }
    if (law_accepts(subject, value)) return true;
  }
  return false;
}

/* ---- States ---- */

void sample_set_strain(Sample *sample, ptrdiff_t i, double l1, double l2) {
  sample->in[i] = l1 * l1 + l2 * l2 - 2.0;
  sample->in[sample->ld + i] = l1 * l1 * l2 * l2 - 1.0;
}

static void start_history(const Subject *subject, Sample *sample, ptrdiff_t i) {
  const int first = kernel_inputs(subject) - (int)subject->table.n_vars;
  for (uint32_t k = 0; k < subject->table.n_vars; k++) {
    sample->in[(first + (ptrdiff_t)k) * sample->ld + i] = law_var(&subject->table, k)->init;
  }
}

/* Point i alone: does the law answer? */
static bool takes_point(const Subject *subject, const Sample *sample, ptrdiff_t i) {
  double in[MAX_ROWS], out[MAX_ROWS];
  mlaw_field field[MAX_PARAMS];
  for (int row = 0; row < kernel_inputs(subject); row++) in[row] = sample->in[row * sample->ld + i];
  kernel_fields(subject, sample->value, field);
  KernelCall call = {.n = 1, .ld = 1, .param = field, .in = in, .out = out, .without = -1};
  return kernel_call(subject, &call) == MLAW_OK;
}

/* Stretches that the law takes, looked for nearer and nearer to rest. */
static bool draw_strain(const Subject *subject, Sample *sample, ptrdiff_t i, uint64_t *state) {
  for (int attempt = 0; attempt < 200; attempt++) {
    const double reach = pow(0.98, attempt);
    const double l1 = 1.0 + reach * (1.2 * draw(state) - 0.4), l2 = 1.0 + reach * (1.2 * draw(state) - 0.4);
    if (fabs(l1 - l2) < 0.1 * reach) continue;
    sample_set_strain(sample, i, l1, l2);
    if (takes_point(subject, sample, i)) return true;
  }
  return false;
}

double sample_full_damage(const Subject *subject, const double *value) {
  mlaw_field field[MAX_PARAMS];
  double beyond_threshold = 0.0;
  kernel_fields(subject, value, field);
  for (int exponent = -40; exponent <= 40; exponent++) {
    double out[3], in[2] = {ldexp(1.0, exponent), 0.0};
    KernelCall call = {.n = 1, .ld = 1, .param = field, .in = in, .out = out, .without = -1};
    if (kernel_call(subject, &call) != MLAW_OK) continue;
    if (out[1] >= 1.0) return in[0];
    if (out[0] > 0.0 && beyond_threshold == 0.0) beyond_threshold = in[0];
  }
  return beyond_threshold > 0.0 ? 2.0 * beyond_threshold : 1.0;
}

/* Principal tension of the membrane phi = (I1 - I2/(1 + I2))/2, which stands for any. */
static double tension(double l1, double l2) {
  return l1 / l2 - pow(l1 * l2, -3.0);
}

void sample_set_channels(const Subject *subject, Sample *sample, ptrdiff_t i, bool at_end, double l1,
                         double l2) {
  const double large = fmax(l1, l2), small = fmin(l1, l2);
  const double I1 = l1 * l1 + l2 * l2 - 2.0, I2 = l1 * l1 * l2 * l2 - 1.0;
  const double channel[MLAW_N_CHANNELS] = {[MLAW_Y] = 0.5 * (I1 - I2 / (1.0 + I2)),
                                           [MLAW_I1] = I1,
                                           [MLAW_I2] = I2,
                                           [MLAW_L1] = large,
                                           [MLAW_L2] = small,
                                           [MLAW_T1] = tension(large, small),
                                           [MLAW_T2] = tension(small, large)};
  const ptrdiff_t rows = (kernel_inputs(subject) - 1 - (ptrdiff_t)subject->table.n_vars) / 2;
  double *column = sample->in + (at_end ? rows * sample->ld : 0) + i;
  for (int c = 0; c < MLAW_N_CHANNELS; c++) {
    if (!(subject->damage->needs >> c & 1u)) continue;
    *column = channel[c];
    column += sample->ld;
  }
}

static bool draw_point(const Subject *subject, Sample *sample, ptrdiff_t i, double Y_full, uint64_t *state) {
  start_history(subject, sample, i);
  if (subject->energy) return draw_strain(subject, sample, i, state);
  if (subject->damage->update) {
    const double l1 = 1.0 + 0.4 * draw(state), l2 = 1.0 - 0.2 * draw(state), more = 1.0 + draw(state);
    const ptrdiff_t damage = kernel_inputs(subject) - 1 - (ptrdiff_t)subject->table.n_vars;
    sample_set_channels(subject, sample, i, false, l1, l2);
    sample_set_channels(subject, sample, i, true, l1 * more, l2);
    sample->in[damage * sample->ld + i] = 0.5 * draw(state);
  } else {
    sample->in[i] = 1.5 * Y_full * draw(state);
    sample->in[sample->ld + i] = draw(state);
  }
  return true;
}

static Verdict start_sample(const Subject *subject, int set, ptrdiff_t n, ptrdiff_t ld, uint64_t *state,
                            Sample *sample) {
  *state = 1973 + (uint64_t)set;
  memset(sample, 0, sizeof *sample);
  sample->n = n;
  sample->ld = ld;
  if (subject->table.n_params > MAX_PARAMS || kernel_inputs(subject) > MAX_ROWS ||
      kernel_outputs(subject) > MAX_ROWS) {
    return verdict(CONFORMANCE_FAILED, "expected at most %d parameters and 16 variables, found more",
                   MAX_PARAMS);
  }
  if (draw_parameters(subject, set, state, sample->value)) return verdict_passed();
  return verdict(CONFORMANCE_FAILED,
                 "expected check() to accept some parameters of the calibrated range, found none");
}

Verdict sample_make(const Subject *subject, int set, ptrdiff_t n, ptrdiff_t ld, Sample *sample) {
  uint64_t state;
  EXPECT(start_sample(subject, set, n, ld, &state, sample));
  const bool is_explicit = subject->damage && !subject->damage->update;
  const double Y_full = is_explicit ? sample_full_damage(subject, sample->value) : 0.0;
  for (ptrdiff_t i = 0; i < n; i++) {
    if (draw_point(subject, sample, i, Y_full, &state)) continue;
    return verdict(CONFORMANCE_FAILED,
                   "expected the law to take some strains near rest, found that it refuses all");
  }
  return verdict_passed();
}

Verdict sample_make_mild(const Subject *subject, ptrdiff_t n, ptrdiff_t ld, Sample *sample) {
  uint64_t state;
  EXPECT(start_sample(subject, 0, n, ld, &state, sample));
  for (ptrdiff_t i = 0; i < n; i++) {
    const double stretch = 1.0 + 1e-3 * (double)i / (double)n;
    start_history(subject, sample, i);
    if (subject->energy) {
      sample_set_strain(sample, i, stretch, 1.0);
    } else if (subject->damage->update) {
      sample_set_channels(subject, sample, i, false, stretch, 1.0);
      sample_set_channels(subject, sample, i, true, stretch, 1.0);
    } else {
      sample->in[i] = stretch - 1.0;
    }
  }
  return verdict_passed();
}

Verdict sample_evaluate(const Subject *subject, const Sample *sample, double dt, double *out) {
  mlaw_field field[MAX_PARAMS];
  kernel_fields(subject, sample->value, field);
  KernelCall call = {.n = sample->n,
                     .ld = sample->ld,
                     .param = field,
                     .in = sample->in,
                     .out = out,
                     .without = -1,
                     .dt = dt};
  const int status = kernel_call(subject, &call);
  if (status == MLAW_OK) return verdict_passed();
  return verdict(CONFORMANCE_FAILED,
                 "expected status 0 on points that it takes one by one, found %d at point %lld: %.200s",
                 status, (long long)call.err.point, call.err.text);
}
