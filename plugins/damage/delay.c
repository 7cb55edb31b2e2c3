/* Delayed damage: it follows `marigo` at a bounded rate (Ladeveze 1992; Allix & Deu 1997).
 *
 *     drive      Y, the energy release rate;   zeta(Y) = <Y - Y_D>/Y_C
 *     threshold  damage grows where zeta(Y) > d
 *     evolution  dd/dt = {1 - exp(-a <zeta(Y) - d>)}/tau_c <= 1/tau_c
 *
 * tau_c is the shortest time to full damage and a says how sharply the rate turns to its bound; tau_c -> 0 is
 * `marigo`.  The step is the exact solution with zeta held at its mean over the step: stable for any dt, of
 * second order.  Dissipation Y dd/dt >= 0. */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { Y_D, Y_C, TAU_C, A, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_D] = {.name = "Y_D",
             .unit = "N/m",
             .about = "energy release rate at which damage starts",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
    [Y_C] = {.name = "Y_C",
             .unit = "N/m",
             .about = "hardening modulus: rupture is the aim at Y_D + Y_C",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
    [TAU_C] = {.name = "tau_c",
               .unit = "s",
               .about = "shortest time to full damage",
               .dim = {0, 0, 1},
               .flags = MLAW_REQUIRED | MLAW_OPEN_LO,
               .lo = 0.0,
               .hi = INFINITY,
               .ok_lo = 0.0,
               .ok_hi = INFINITY},
    [A] = {.name = "a",
           .unit = "1",
           .about = "sharpness of the turn to the bounded rate",
           .flags = MLAW_OPEN_LO,
           .value = 1.0,
           .lo = 0.0,
           .hi = INFINITY,
           .ok_lo = 0.1,
           .ok_hi = 20.0},
};

/* <Y - Y_D>/Y_C; in place of a Y_C of 0 a small number, so that 0/0 does not arise. */
static inline double target(double Y, double y_d, double y_c) {
  return Y > y_d ? (Y - y_d) / (y_c > FLT_MIN ? y_c : FLT_MIN) : 0.0;
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
};

static const mlaw_damage *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "delay",
    .version = "1.0",
    .license = "MIT",
    .author = "the Capsella authors",
    .n_damage = 1,
    .damage = laws,
};

const mlaw_plugin *mlaw_plugin_v1(uint32_t host_minor) {
  (void)host_minor;
  return &plugin;
}
