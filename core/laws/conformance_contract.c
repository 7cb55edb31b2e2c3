/* Group `contract`: the rules of mlaw.h that hold for every law, whatever it computes. */
#include "base/timer.h"
#include "laws/conformance_sample.h"
#include <math.h>
#include <pthread.h>
#include <string.h>

enum { POINTS = 37, LD = 43 }; /* no multiple of a vector's length, and a leading dimension of its own */
static const double DT = 0.01;

/* A value that no law computes: marks what was not written. */
static double mark(void) {
  const uint64_t pattern = UINT64_C(0x7ff8dead0000beef);
  double value;
  memcpy(&value, &pattern, sizeof value);
  return value;
}

static bool is_mark(double value) {
  const double marked = mark();
  return memcmp(&value, &marked, sizeof value) == 0;
}

/* An output table between guards. */
typedef struct {
  double before[MAX_LD], out[TABLE], after[MAX_LD];
} Guarded;

static void fill_marks(Guarded *guarded) {
  for (int i = 0; i < MAX_LD; i++) guarded->before[i] = guarded->after[i] = mark();
  for (int i = 0; i < TABLE; i++) guarded->out[i] = mark();
}

/* Equal up to what another order of vector and scalar instructions may do to the last digits. */
static bool is_close(double a, double b) {
  return a == b || fabs(a - b) <= 1e-13 * (1.0 + fabs(b)) || (is_mark(a) && is_mark(b));
}

/* The first `n` points of each row of b against a, where point i of b is point (first + step * i) of a. */
static Verdict compare(const Subject *subject, const char *what, const double *a, ptrdiff_t lda,
                       ptrdiff_t first, ptrdiff_t step, const double *b, ptrdiff_t ldb, ptrdiff_t n) {
  for (int row = 0; row < kernel_outputs(subject); row++) {
    for (ptrdiff_t i = 0; i < n; i++) {
      const double expected = a[row * lda + first + step * i], found = b[row * ldb + i];
      if (is_close(found, expected)) continue;
      return verdict(CONFORMANCE_FAILED, "%s: expected %s = %.17g at point %td, found %.17g", what,
                     kernel_output_name(subject, row), expected, first + step * i, found);
    }
  }
  return verdict_passed();
}

static Verdict prepare(const Subject *subject, Sample *sample, double *out) {
  EXPECT(sample_make(subject, 0, POINTS, LD, sample));
  return sample_evaluate(subject, sample, DT, out);
}

/* ---- Where a law writes ---- */

static Verdict no_hole(const Subject *subject) {
  Sample sample;
  Guarded guarded;
  fill_marks(&guarded);
  EXPECT(prepare(subject, &sample, guarded.out));
  for (int row = 0; row < kernel_outputs(subject); row++) {
    for (ptrdiff_t i = 0; i < POINTS; i++) {
      const double value = guarded.out[row * LD + i];
      const char *name = kernel_output_name(subject, row);
      if (is_mark(value)) {
        return verdict(CONFORMANCE_FAILED,
                       "expected %s to be written at every point, found point %td left out", name, i);
      }
      if (!isfinite(value)) {
        return verdict(CONFORMANCE_FAILED, "expected a finite %s, found %g at point %td", name, value, i);
      }
    }
  }
  return verdict_passed();
}

static Verdict no_overrun(const Subject *subject) {
  Sample sample;
  Guarded guarded;
  fill_marks(&guarded);
  EXPECT(prepare(subject, &sample, guarded.out));
  for (int row = 0; row < kernel_outputs(subject); row++) {
    for (ptrdiff_t i = POINTS; i < LD; i++) {
      if (is_mark(guarded.out[row * LD + i])) continue;
      return verdict(CONFORMANCE_FAILED,
                     "expected entries n .. ld-1 of %s to be left alone, found n+%td written",
                     kernel_output_name(subject, row), i - POINTS);
    }
  }
  for (int i = 0; i < MAX_LD; i++) {
    if (is_mark(guarded.before[i]) && is_mark(guarded.after[i])) continue;
    return verdict(CONFORMANCE_FAILED, "expected writes within the arrays, found one outside");
  }
  for (ptrdiff_t i = (ptrdiff_t)kernel_outputs(subject) * LD; i < TABLE; i++) {
    if (is_mark(guarded.out[i])) continue;
    return verdict(CONFORMANCE_FAILED, "expected writes within the arrays, found one beyond the last row");
  }
  return verdict_passed();
}

static Verdict n_zero(const Subject *subject) {
  Sample sample;
  Guarded guarded;
  EXPECT(sample_make(subject, 0, POINTS, LD, &sample));
  fill_marks(&guarded);
  sample.n = 0;
  EXPECT(sample_evaluate(subject, &sample, DT, guarded.out));
  for (int i = 0; i < TABLE; i++) {
    if (!is_mark(guarded.out[i]))
      return verdict(CONFORMANCE_FAILED, "expected nothing written for n = 0, found a value");
  }
  return verdict_passed();
}

static Verdict null_outputs(const Subject *subject) {
  Sample sample;
  double all[TABLE];
  mlaw_field field[MAX_PARAMS];
  EXPECT(prepare(subject, &sample, all));
  kernel_fields(subject, sample.value, field);
  for (int row = 0; row < kernel_outputs(subject); row++) {
    Guarded guarded;
    int count;
    const int first = kernel_group(subject, row, &count);
    if (!kernel_optional(subject, row) || first != row) continue;
    fill_marks(&guarded);
    KernelCall call = {
        .n = POINTS, .ld = LD, .param = field, .in = sample.in, .out = guarded.out, .without = row, .dt = DT};
    if (kernel_call(subject, &call) != MLAW_OK) {
      return verdict(CONFORMANCE_FAILED, "expected status 0 without %s, found %d: %.200s",
                     kernel_output_name(subject, row), call.err.status, call.err.text);
    }
    for (int k = first; k < first + count; k++) { /* these must stay marked; the rest must be as before */
      for (int i = 0; i < LD; i++) all[k * LD + i] = mark();
    }
    EXPECT(compare(subject, "with an output left out", all, LD, 0, 1, guarded.out, LD, POINTS));
    EXPECT(sample_evaluate(subject, &sample, DT, all));
  }
  return verdict_passed();
}

static Verdict inputs_untouched(const Subject *subject) {
  Sample sample, copy;
  double out[TABLE];
  EXPECT(sample_make(subject, 0, POINTS, LD, &sample));
  copy = sample;
  EXPECT(sample_evaluate(subject, &sample, DT, out));
  if (memcmp(&sample, &copy, sizeof sample) == 0) return verdict_passed();
  return verdict(CONFORMANCE_FAILED,
                 "expected inputs, old state and parameters to be only read, found one changed");
}

/* ---- What a result depends on ---- */

static Verdict batch_equals_single(const Subject *subject) {
  Sample sample;
  double batch[TABLE], single[MAX_ROWS], in[MAX_ROWS];
  mlaw_field field[MAX_PARAMS];
  EXPECT(prepare(subject, &sample, batch));
  kernel_fields(subject, sample.value, field);
  for (ptrdiff_t i = 0; i < POINTS; i++) {
    for (int row = 0; row < kernel_inputs(subject); row++) in[row] = sample.in[row * LD + i];
    KernelCall call = {.n = 1, .ld = 1, .param = field, .in = in, .out = single, .without = -1, .dt = DT};
    if (kernel_call(subject, &call) != MLAW_OK) {
      return verdict(CONFORMANCE_FAILED,
                     "expected point %td of a good batch to be good alone, found status %d", i,
                     call.err.status);
    }
    EXPECT(compare(subject, "alone", batch, LD, i, 0, single, 1, 1));
  }
  return verdict_passed();
}

static Verdict order_independent(const Subject *subject) {
  Sample sample, reversed;
  double forward[TABLE], backward[TABLE];
  EXPECT(prepare(subject, &sample, forward));
  reversed = sample;
  for (int row = 0; row < kernel_inputs(subject); row++) {
    for (ptrdiff_t i = 0; i < POINTS; i++) reversed.in[row * LD + i] = sample.in[row * LD + POINTS - 1 - i];
  }
  EXPECT(sample_evaluate(subject, &reversed, DT, backward));
  return compare(subject, "in reversed order", forward, LD, POINTS - 1, -1, backward, LD, POINTS);
}

static Verdict any_ld(const Subject *subject) {
  Sample wide, tight;
  double expected[TABLE], found[TABLE];
  EXPECT(prepare(subject, &wide, expected));
  EXPECT(sample_make(subject, 0, POINTS, POINTS, &tight));
  EXPECT(sample_evaluate(subject, &tight, DT, found));
  return compare(subject, "with ld = n", expected, LD, 0, 1, found, POINTS, POINTS);
}

static Verdict uniform_equals_per_point(const Subject *subject) {
  Sample sample;
  double uniform[TABLE], varied[TABLE], each[MAX_PARAMS][POINTS];
  mlaw_field field[MAX_PARAMS];
  EXPECT(prepare(subject, &sample, uniform));
  for (uint32_t k = 0; k < subject->table.n_params; k++) {
    for (int i = 0; i < POINTS; i++) each[k][i] = sample.value[k];
    field[k] = (mlaw_field){each[k], 1};
  }
  KernelCall call = {
      .n = POINTS, .ld = LD, .param = field, .in = sample.in, .out = varied, .without = -1, .dt = DT};
  if (kernel_call(subject, &call) != MLAW_OK) {
    return verdict(CONFORMANCE_FAILED, "expected status 0 with a parameter for each point, found %d",
                   call.err.status);
  }
  return compare(subject, "with a parameter for each point", uniform, LD, 0, 1, varied, LD, POINTS);
}

/* Each point has its own parameter set: point i must be what a uniform batch of that set gives. */
static Verdict own_parameter_per_point(const Subject *subject) {
  Sample sample, other;
  double expected[2][TABLE], found[TABLE], each[MAX_PARAMS][POINTS];
  mlaw_field field[MAX_PARAMS];
  EXPECT(prepare(subject, &sample, expected[0]));
  EXPECT(sample_make(subject, 1, POINTS, LD, &other));
  memcpy(other.in, sample.in, sizeof other.in);
  mlaw_field other_field[MAX_PARAMS];
  kernel_fields(subject, other.value, other_field);
  KernelCall call = {.n = POINTS,
                     .ld = LD,
                     .param = other_field,
                     .in = sample.in,
                     .out = expected[1],
                     .without = -1,
                     .dt = DT};
  if (kernel_call(subject, &call) != MLAW_OK) {
    return verdict(CONFORMANCE_SKIPPED, "the law does not take the same points with other parameters");
  }
  for (uint32_t k = 0; k < subject->table.n_params; k++) {
    for (int i = 0; i < POINTS; i++) each[k][i] = i % 2 ? other.value[k] : sample.value[k];
    field[k] = (mlaw_field){each[k], 1};
  }
  call.param = field;
  call.out = found;
  if (kernel_call(subject, &call) != MLAW_OK) {
    return verdict(CONFORMANCE_FAILED, "expected status 0 with parameters that vary, found %d",
                   call.err.status);
  }
  for (ptrdiff_t i = 0; i < POINTS; i++) {
    double single[MAX_ROWS];
    for (int row = 0; row < kernel_outputs(subject); row++) single[row] = found[row * LD + i];
    EXPECT(compare(subject, "with parameters that vary", expected[i % 2], LD, i, 0, single, 1, 1));
  }
  return verdict_passed();
}

/* First what nothing came before, then the same after states of all sorts. */
static Verdict keeps_nothing(const Subject *subject) {
  Sample mild, other;
  double first[TABLE], out[TABLE];
  EXPECT(sample_make_mild(subject, POINTS, LD, &mild));
  EXPECT(sample_evaluate(subject, &mild, DT, first));
  for (int set = 0; set < PARAMETER_SETS; set++) {
    EXPECT(sample_make(subject, set, POINTS, LD, &other));
    EXPECT(sample_evaluate(subject, &other, DT, out));
    EXPECT(sample_evaluate(subject, &mild, DT, out));
    EXPECT(compare(subject, "the same call again, after others", first, LD, 0, 1, out, LD, POINTS));
  }
  return verdict_passed();
}

typedef struct {
  const Subject *subject;
  const Sample *sample;
  const double *expected;
  Verdict verdict;
} Worker;

/* Long enough for threads to come between each other even where they share one processor. */
static const double SECONDS_BESIDE_OTHERS = 0.05;

static Verdict repeat(const Worker *worker) {
  double out[TABLE];
  const double end = timer_wall_seconds() + SECONDS_BESIDE_OTHERS;
  do {
    EXPECT(sample_evaluate(worker->subject, worker->sample, DT, out));
    EXPECT(compare(worker->subject, "beside other threads", worker->expected, LD, 0, 1, out, LD, POINTS));
  } while (timer_wall_seconds() < end);
  return verdict_passed();
}

static void *run_worker(void *argument) {
  Worker *worker = argument;
  worker->verdict = repeat(worker);
  return NULL;
}

static Verdict threads_agree(const Subject *subject) {
  enum { THREADS = 4 };
  Sample sample[THREADS];
  double expected[THREADS][TABLE];
  Worker worker[THREADS];
  pthread_t thread[THREADS];
  int started = 0;
  for (int k = 0; k < THREADS; k++) {
    EXPECT(sample_make(subject, k, POINTS, LD, &sample[k]));
    EXPECT(sample_evaluate(subject, &sample[k], DT, expected[k]));
    worker[k] = (Worker){subject, &sample[k], expected[k], verdict_passed()};
  }
  while (started < THREADS && pthread_create(&thread[started], NULL, run_worker, &worker[started]) == 0)
    started++;
  for (int k = 0; k < started; k++) pthread_join(thread[k], NULL);
  for (int k = 0; k < started; k++) EXPECT(worker[k].verdict);
  return started == THREADS ? verdict_passed() : verdict(CONFORMANCE_SKIPPED, "threads cannot be started");
}

static Verdict fp_mode_kept(const Subject *subject) {
  Sample sample;
  double out[TABLE];
  const bool alive = subnormals_live();
  EXPECT(prepare(subject, &sample, out));
  if (!alive || subnormals_live()) return verdict_passed();
  return verdict(CONFORMANCE_FAILED,
                 "expected the floating-point mode to stay as it is, found subnormal numbers flushed");
}

/* ---- Limits ---- */

/* A law that refuses some large strain must name the point, say why, and take it back when asked for less. */
static Verdict domain_error_names_point(const Subject *subject) {
  Sample sample;
  double out[TABLE];
  mlaw_field field[MAX_PARAMS];
  enum { CULPRIT = 23 };
  EXPECT(prepare(subject, &sample, out));
  kernel_fields(subject, sample.value, field);
  for (double stretch = 2.0; stretch < 1e4; stretch *= 1.5) {
    sample_set_strain(&sample, CULPRIT, stretch, 1.0);
    KernelCall call = {
        .n = POINTS, .ld = LD, .param = field, .in = sample.in, .out = out, .without = -1, .dt = DT};
    const int status = kernel_call(subject, &call);
    if (status == MLAW_OK) continue;
    if (call.err.point == CULPRIT && call.err.text[0] && call.err.status == status) return verdict_passed();
    return verdict(
        CONFORMANCE_FAILED,
        "expected status, point and reason of the refusal of point %d, found status %d (returned %d), "
        "point %lld, `%.200s`",
        CULPRIT, call.err.status, status, (long long)call.err.point, call.err.text);
  }
  return verdict(CONFORMANCE_SKIPPED, "the law refuses no stretch up to 10000");
}

static Verdict finite_with(const Subject *subject, const Sample *sample, const mlaw_param *param,
                           double value) {
  double out[TABLE];
  EXPECT(sample_evaluate(subject, sample, DT, out));
  for (int row = 0; row < kernel_outputs(subject); row++) {
    for (ptrdiff_t i = 0; i < POINTS; i++) {
      if (isfinite(out[row * LD + i])) continue;
      return verdict(CONFORMANCE_FAILED,
                     "expected a finite %s with %.60s = %g, which its range allows, found %g",
                     kernel_output_name(subject, row), param->name, value, out[row * LD + i]);
    }
  }
  return verdict_passed();
}

/* Values at the closed ends of a hard range must give finite results, or be refused by check; near an open
 * end a law may well have none. */
static Verdict finite_at_bounds(const Subject *subject) {
  Sample sample;
  EXPECT(sample_make(subject, 0, POINTS, LD, &sample));
  for (uint32_t k = 0; k < subject->table.n_params; k++) {
    const mlaw_param *param = law_param(&subject->table, k);
    const double plain = sample.value[k], end[2] = {param->lo, param->hi};
    const bool closed[2] = {!(param->flags & MLAW_OPEN_LO), !(param->flags & MLAW_OPEN_HI)};
    for (int side = 0; side < 2; side++) {
      mlaw_error err = {.point = -1};
      if (!isfinite(end[side]) || !closed[side]) continue;
      sample.value[k] = end[side];
      if (subject->table.check && subject->table.check(sample.value, &err) != MLAW_OK) continue;
      EXPECT(finite_with(subject, &sample, param, end[side]));
    }
    sample.value[k] = plain;
  }
  return verdict_passed();
}

static const ConformanceTest tests[] = {
    {FOR_LAW, "no-hole", "every entry asked for is written, and finite", no_hole},
    {FOR_LAW, "no-overrun", "nothing else is written", no_overrun},
    {FOR_LAW, "n-zero", "a batch of no points is legal and writes nothing", n_zero},
    {FOR_LAW, "null-outputs", "outputs not asked for change nothing", null_outputs},
    {FOR_LAW, "inputs-untouched", "inputs and old state are only read", inputs_untouched},
    {FOR_LAW, "batch-equals-single", "a point alone gives what it gives in a batch", batch_equals_single},
    {FOR_LAW, "order-independent", "the order of points does not matter", order_independent},
    {FOR_LAW, "any-ld", "the leading dimension does not matter", any_ld},
    {FOR_LAW, "uniform-equals-per-point", "one parameter for all equals the same for each",
     uniform_equals_per_point},
    {FOR_LAW, "own-parameter-per-point", "parameters that vary reach their own point",
     own_parameter_per_point},
    {FOR_LAW, "keeps-nothing", "a call leaves no trace in the next", keeps_nothing},
    {FOR_LAW, "threads-agree", "calls from several threads do not disturb each other", threads_agree},
    {FOR_LAW, "fp-mode-kept", "kernels leave the floating-point mode alone", fp_mode_kept},
    {FOR_ENERGY, "domain-error-names-point", "a refusal names the point and the reason",
     domain_error_names_point},
    {FOR_LAW, "finite-at-bounds", "values at closed ends of a hard range can be used", finite_at_bounds},
};

const ConformanceGroup conformance_contract = {"contract", tests, sizeof tests / sizeof *tests};
