/* Brittle damage whose hardening is a power of damage; m = 1 is `marigo` (Marigo 1981). */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      Y, the energy release rate\n"
    "    threshold  f(Y; d) = Y - kappa(d) <= 0,   kappa(d) = Y_D + Y_C d^m\n"
    "    evolution  zeta(Y) = <(Y - Y_D)/Y_C>^(1/m)\n"
    "\n"
    "Full damage at Y_D + Y_C, for any m: with m > 1 damage starts fast and ends slowly, with m < 1 it\n"
    "ends fast.  m = 1 is `marigo`.  Y_C = 0 is the brittle limit.\n"
    "\n"
    "Associated; dissipation Y dd/dt >= 0.\n";

enum { Y_D, Y_C, M, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_D] = {MLAW_TENSION("Y_D", "energy release rate at which damage starts"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
    [Y_C] = {MLAW_TENSION("Y_C", "hardening modulus: rupture at Y_D + Y_C"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
    [M] = {MLAW_NUMBER("m", "exponent of hardening; 1: linear"), .flags = MLAW_OPEN_LO, .value = 1.0,
           MLAW_WITHIN(0.0, INFINITY), MLAW_FITTED(0.2, 5.0)},
};

/* (Y - Y_D)/Y_C between 0 and 1, where the law has its curve. */
static inline double progress(double Y, double y_d, double y_c) {
  const double x = (Y - y_d) / mlaw_not_zero(y_c);
  return x < 0.0 ? 0.0 : x < 1.0 ? x : 1.0;
}

static int threshold(const mlaw_damage_args *a) {
  const double *Y = a->chan[MLAW_Y], *d = a->d0;
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C], m = a->param[M];
  double *restrict f = a->f;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++)
    f[i] = Y[i] - (mlaw_at(y_d, i) + mlaw_at(y_c, i) * pow(d[i], mlaw_at(m, i)));
  return MLAW_OK;
}

static int evolution(const mlaw_damage_args *a) {
  const double *Y = a->chan[MLAW_Y];
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C], m = a->param[M];
  const ptrdiff_t n = (ptrdiff_t)a->n;
  double *restrict zeta = a->zeta;
  for (ptrdiff_t i = 0; i < n; i++)
    zeta[i] = pow(progress(Y[i], mlaw_at(y_d, i), mlaw_at(y_c, i)), 1.0 / mlaw_at(m, i));
  if (a->dzeta) { /* zeta/(m (Y - Y_D)) on the curve, 0 where it is flat */
    double *restrict dzeta = a->dzeta;
    for (ptrdiff_t i = 0; i < n; i++) {
      const double x = progress(Y[i], mlaw_at(y_d, i), mlaw_at(y_c, i));
      dzeta[i] = x > 0.0 && x < 1.0 ? zeta[i] / (mlaw_at(m, i) * (Y[i] - mlaw_at(y_d, i))) : 0.0;
    }
  }
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "power",
    .title = "Brittle damage with power hardening",
    .source = "Marigo, C. R. Acad. Sci. II 292 (1981), with kappa(d) = Y_D + Y_C d^m",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .needs = 1u << MLAW_Y,
    .threshold = threshold,
    .evolution = evolution,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "power", "1.0", "MIT", "the Capsella authors")
