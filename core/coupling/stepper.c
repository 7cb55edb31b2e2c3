#include "coupling/stepper.h"

#include "base/array.h"
#include "coupling/spectral_radius.h"
#include <math.h>
#include <string.h>

enum { RADIUS_EVERY = 25 }; /* accepted steps between two estimates of the spectral radius */

static const double RADIUS_ERROR = 1.08;  /* the power iteration converges from below: 7 % on a membrane */
static const double RADIUS_SAFETY = 1.15; /* and the radius may grow until it is estimated anew */
static const double ORDER_EXPONENT = 1.0 / 3; /* the error of a step goes as h^3 */
static const double SMALLEST_STEP = 1e-10;

/* An error below this share of the tolerance says that the next step may be much longer, for which the
 * controller aims at LENGTHENED^3 of the tolerance at once: where two errors are going, which is what a PI
 * controller looks at, takes it ten steps to get there from the start. */
static const double TIMID = 0.05, LENGTHENED = 0.7;

/* Damage may grow by this times sqrt(tolerance) in a step (the global error goes as its square), except in
 * steps as short as this times the tolerance. */
static const double LARGEST_GROWTH = 5, SHORTEST_GROWTH = 10;

Status stepper_new(Stepper *s, Rhs rhs, StepperOptions options, Error *error) {
  Status status = STATUS_OK;
  *s = (Stepper){.rhs = rhs, .options = options, .integrator = integrator_get(options.integrator)};
  TRY(ARRAY_NEW(&s->x, rhs.n, error));
  TRY(ARRAY_NEW(&s->v, rhs.n, error));
  TRY(ARRAY_NEW(&s->x1, rhs.n, error));
  TRY(ARRAY_NEW(&s->v1, rhs.n, error));
  TRY(ARRAY_NEW(&s->direction, rhs.n, error));
  TRY(ARRAY_NEW(&s->work, INTEGRATOR_WORK * (size_t)rhs.n, error));
cleanup:
  if (status != STATUS_OK) stepper_free(s);
  return status;
}

void stepper_free(Stepper *s) {
  array_free(s->x);
  array_free(s->v);
  array_free(s->x1);
  array_free(s->v1);
  array_free(s->direction);
  array_free(s->work);
  *s = (Stepper){0};
}

/* ---- stability ---- */

double stepper_stability_limit(const Stepper *s) {
  const int most = s->integrator->max_stages;
  return s->memory.rho > 0 ? s->integrator->reach(most) / s->memory.rho : INFINITY;
}

static Status open_step(Stepper *s, Error *error) {
  if (s->is_open || !s->rhs.open_step) return STATUS_OK;
  const Status status = s->rhs.open_step(s->rhs.context, s->x, s->memory.t, s->v, error);
  s->is_open = status == STATUS_OK;
  return status;
}

Status stepper_measure_radius(Stepper *s, Error *error) {
  Status status = STATUS_OK;
  int evaluations = 0;
  s->memory.steps_since_rho = 0;
  TRY(open_step(s, error));
  TRY(spectral_radius(&s->rhs, s->memory.t, s->x, s->v, s->direction, s->x1, s->v1, &s->memory.rho,
                      &evaluations, error));
cleanup:
  return status;
}

static bool is_unstable(const Stepper *s, double step) {
  return !s->options.is_auto && step > stepper_stability_limit(s) / RADIUS_ERROR;
}

static Status check_fixed_step(const Stepper *s, Status code, Error *error) {
  const double limit = stepper_stability_limit(s) / RADIUS_ERROR;
  if (s->options.allow_unstable || !is_unstable(s, s->options.fixed_step)) return STATUS_OK;
  return error_set(
      error, code,
      "time.step: %g at t = %g is beyond the stability limit %.3g of %s (spectral radius %.4g); write "
      "`step: auto`, or a step of at most %.2g",
      s->options.fixed_step, s->memory.t, limit, s->integrator->name, s->memory.rho, 0.95 * limit);
}

/* ---- start ---- */

Status stepper_start(Stepper *s, double t, const double *x, Error *error) {
  Status status = STATUS_OK;
  s->memory = (StepperMemory){.t = t, .error_before = 1};
  memcpy(s->x, x, (size_t)s->rhs.n * sizeof *x);
  TRY(s->rhs.evaluate(s->rhs.context, s->x, t, 0, s->v, error));
  spectral_radius_seed(s->rhs.n, s->x, s->direction);
  s->is_open = false;
  TRY(stepper_measure_radius(s, error));
  s->is_open = false; /* as after a restart from here: the counts are the same */
  TRY(check_fixed_step(s, STATUS_INPUT, error));
  s->memory.h_next = s->options.is_auto ? 0.25 / s->memory.rho : s->options.fixed_step;
cleanup:
  return status;
}

/* ---- one step ---- */

/* Root mean square over the nodes of the error of the step, over the tolerance. */
static double scaled_error(const Stepper *s, double h) {
  double sum = 0;
  for (int i = 0; i < s->rhs.n; i++) {
    const double e = 0.8 * (s->x[i] - s->x1[i]) + 0.4 * h * (s->v[i] + s->v1[i]);
    sum += e * e;
  }
  return sqrt(3 * sum / s->rhs.n) / s->options.tolerance;
}

/* Growth of damage in the step over what is allowed; as the cube, so that it asks for the step that an error
 * of the same size would.  0 where it does not count. */
static double scaled_growth(const Stepper *s, double h) {
  const double tolerance = s->options.tolerance;
  if (!s->rhs.damage_growth || !s->options.is_auto || h <= SHORTEST_GROWTH * tolerance) return 0;
  return pow(s->rhs.damage_growth(s->rhs.context) / (LARGEST_GROWTH * sqrt(tolerance)), 1 / ORDER_EXPONENT);
}

static double clamp(double value, double low, double high) {
  return fmin(fmax(value, low), high);
}

/* Step wanted after one of size h with scaled error or growth e. */
static double next_step(const Stepper *s, double h, double e) {
  if (e < TIMID) return h * fmin(LENGTHENED * pow(fmax(e, 1e-8), -ORDER_EXPONENT), 4.0);
  const double last = s->memory.error_before; /* a small one has had its effect */
  const double before = last < TIMID ? pow(LENGTHENED, 1 / ORDER_EXPONENT) : last;
  return h * clamp(0.85 * pow(e, -0.7 * ORDER_EXPONENT) * pow(before, 0.4 * ORDER_EXPONENT), 0.2, 4.0);
}

/* The step to try: what is wanted, within stability, ending on t_limit without a tiny last step. */
static double choose_step(const Stepper *s, double t_limit) {
  double h = s->memory.h_next;
  const double left = t_limit - s->memory.t;
  if (s->options.is_auto) {
    const double limit = stepper_stability_limit(s) / RADIUS_SAFETY;
    if (h > limit) h = limit;
  }
  if (left <= h * (1 + 1e-9)) return left;
  if (s->options.is_auto && left < 2 * h) return 0.5 * left;
  return h;
}

static Status try_step(Stepper *s, double t1, Error *error) {
  Status status = STATUS_OK;
  const double h = t1 - s->memory.t;
  int stages = integrator_stages(s->integrator, RADIUS_SAFETY * h * s->memory.rho);
  if (stages == 0)
    stages = s->integrator->max_stages; /* a fixed step, allowed by the user or within the margin */
  TRY(open_step(s, error));
  TRY(s->integrator->step(&s->rhs, stages, s->memory.t, h, s->x, s->v, s->x1, s->work, error));
  if (s->rhs.constrain) s->rhs.constrain(s->rhs.context, s->x1);
  TRY(s->rhs.evaluate(s->rhs.context, s->x1, s->memory.t, h, s->v1, error));
cleanup:
  return status;
}

/* Keeps what the controller learns from a proposal of size h with scaled error or growth e. */
static void adapt_step(Stepper *s, double h, double e) {
  if (!s->options.is_auto) return;
  const double wanted = next_step(s, h, e), before = s->memory.h_next;
  /* A step cut short to land on a time, or by stability, says little about the size that the error allows. */
  s->memory.h_next = h < 0.99 * before ? fmax(wanted, fmin(before, 4 * h)) : wanted;
  s->memory.error_before = e;
}

/* Explains in `error` why no step can be found. */
static Status give_up(const Stepper *s, double h, Error *error) {
  error->code = STATUS_FAILED;
  if (s->options.is_auto)
    return error_prefix(error, "no step from t = %.6g succeeds, down to %.1e: ", s->memory.t, h);
  return error_prefix(error, "the fixed step %g fails at t = %.6g: ", h, s->memory.t);
}

Status stepper_propose(Stepper *s, double t_limit, Log *log, Error *error) {
  s->has_proposal = false;
  double h = 0;
  Status status = STATUS_OK;
  if (s->memory.steps_since_rho >= RADIUS_EVERY) {
    status = stepper_measure_radius(s, error);
    if (status == STATUS_OK) status = check_fixed_step(s, STATUS_FAILED, error);
  }
  while (status == STATUS_OK || status == STATUS_REJECT) {
    h = choose_step(s, t_limit);
    if (status == STATUS_REJECT && !(s->options.is_auto && h >= SMALLEST_STEP)) return give_up(s, h, error);
    s->t1 = h == t_limit - s->memory.t ? t_limit : s->memory.t + h;
    status = try_step(s, s->t1, error);
    double shrink = 0.25;
    if (status == STATUS_OK) {
      const double of_x = scaled_error(s, h), of_d = scaled_growth(s, h);
      const double e = of_d > of_x ? of_d : of_x; /* NaN stays */
      if (e <= 1 || (!s->options.is_auto && isfinite(e))) {
        adapt_step(s, h, e);
        s->memory.error_max = fmax(s->memory.error_max, of_x * s->options.tolerance);
        s->has_proposal = true;
        return STATUS_OK;
      }
      if (isfinite(e)) shrink = clamp(0.8 * pow(e, -ORDER_EXPONENT), 0.1, 0.8);
      status =
          of_d > of_x
              ? error_set(error, STATUS_REJECT, "damage grows by %.3g times what a step may bring",
                          pow(of_d, ORDER_EXPONENT))
              : error_set(error, STATUS_REJECT, "the error of the step is %.3g times the tolerance", of_x);
    }
    if (status != STATUS_REJECT) break;
    s->memory.rejected_steps++;
    if (s->options.is_auto) s->memory.h_next = shrink * h;
    log_note(log, "t = %.6g: step %.3g rejected: %s", s->memory.t, h, error->text);
    if (s->memory.steps_since_rho > 0) {
      Error ignored; /* the trial just rejected is the better explanation */
      if (stepper_measure_radius(s, &ignored) < 0) return give_up(s, h, error);
    }
  }
  return status;
}

void stepper_interpolate(const Stepper *s, double t, double *x, double *v) {
  const double h = s->t1 - s->memory.t, u = (t - s->memory.t) / h;
  const double a0 = (1 + 2 * u) * (1 - u) * (1 - u), a1 = u * u * (3 - 2 * u);
  const double b0 = h * u * (1 - u) * (1 - u), b1 = h * u * u * (u - 1);
  const double da = 6 * u * (u - 1) / h;
  const double db0 = (1 - u) * (1 - 3 * u), db1 = u * (3 * u - 2);
  for (int i = 0; i < s->rhs.n; i++) {
    x[i] = a0 * s->x[i] + a1 * s->x1[i] + b0 * s->v[i] + b1 * s->v1[i];
    if (v) v[i] = da * (s->x[i] - s->x1[i]) + db0 * s->v[i] + db1 * s->v1[i];
  }
  if (s->rhs.constrain) s->rhs.constrain(s->rhs.context, x);
}

void stepper_shorten(Stepper *s, double t) {
  stepper_interpolate(s, t, s->work, s->work + s->rhs.n);
  memcpy(s->x1, s->work, (size_t)s->rhs.n * sizeof *s->x1);
  memcpy(s->v1, s->work + s->rhs.n, (size_t)s->rhs.n * sizeof *s->v1);
  s->t1 = t;
}

void stepper_accept(Stepper *s) {
  double *x = s->x, *v = s->v;
  s->x = s->x1;
  s->v = s->v1;
  s->x1 = x;
  s->v1 = v;
  s->memory.unstable_steps += is_unstable(s, s->t1 - s->memory.t);
  s->memory.t = s->t1;
  s->memory.steps++;
  s->memory.steps_since_rho++;
  s->is_open = false;
  s->has_proposal = false;
}
