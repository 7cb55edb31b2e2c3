/* Delayed damage: it follows `marigo` at a bounded rate (Ladeveze 1992; Allix & Deu 1997). */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      Y, the energy release rate;   zeta(Y) = <Y - Y_D>/Y_C\n"
    "    threshold  damage grows where zeta(Y) > d\n"
    "    evolution  dd/dt = {1 - exp(-a <zeta(Y) - d>)}/tau_c <= 1/tau_c\n"
    "\n"
    "tau_c is the shortest time to full damage and a says how sharply the rate turns to its bound; as\n"
    "tau_c goes to 0 this becomes `marigo`.  The step is the exact solution with zeta held at its mean\n"
    "over the step: stable for any dt, of second order.\n"
    "\n"
    "Driven by Y, which is conjugate to d; dissipation Y dd/dt >= 0.\n";

enum { Y_D, Y_C, TAU_C, A, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_D] = {MLAW_TENSION("Y_D", "energy release rate at which damage starts"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
    [Y_C] = {MLAW_TENSION("Y_C", "hardening modulus: rupture is the aim at Y_D + Y_C"),
             .flags = MLAW_REQUIRED, MLAW_RANGE(0.0, INFINITY)},
    [TAU_C] = {MLAW_TIME("tau_c", "shortest time to full damage"), .flags = MLAW_REQUIRED | MLAW_OPEN_LO,
               MLAW_RANGE(0.0, INFINITY)},
    [A] = {MLAW_NUMBER("a", "sharpness of the turn to the bounded rate"), .flags = MLAW_OPEN_LO, .value = 1.0,
           MLAW_WITHIN(0.0, INFINITY), MLAW_FITTED(0.1, 20.0)},
};

/* <Y - Y_D>/Y_C */
static inline double target(double Y, double y_d, double y_c) {
  return Y > y_d ? (Y - y_d) / mlaw_not_zero(y_c) : 0.0;
}

/* What w = a (zeta - d) loses over s = a dt/tau_c: dw/ds = exp(-w) - 1, hence the first line.  The second
 * says the same for w and s so large that a difference with 1 has no digits left. */
static inline double lost(double w, double s) {
  const double least = fmin(w, s), most = fmax(w, s);
  if (least < 1.0) return -log1p(-expm1(-w) * expm1(-s));
  return least - log1p(exp(least - most) - exp(-most));
}

static int update(const mlaw_damage_args *a) {
  const double *before = a->chan0[MLAW_Y], *now = a->chan[MLAW_Y], *d0 = a->d0;
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C], tau = a->param[TAU_C], sharpness = a->param[A];
  double *restrict d = a->d1;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double zeta0 = target(before[i], mlaw_at(y_d, i), mlaw_at(y_c, i)),
                 zeta1 = target(now[i], mlaw_at(y_d, i), mlaw_at(y_c, i));
    const double ahead = 0.5 * (zeta0 + zeta1) - d0[i], rate = mlaw_at(sharpness, i);
    d[i] = ahead > 0.0 ? d0[i] + lost(rate * ahead, rate * a->dt / mlaw_at(tau, i)) / rate : d0[i];
  }
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "delay",
    .title = "Brittle damage at a bounded rate",
    .source = "Ladeveze (1992); Allix & Deu, Eng. Trans. 45 (1997)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .needs = 1u << MLAW_Y,
    .update = update,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "delay", "1.0", "MIT", "the Capsella authors")
