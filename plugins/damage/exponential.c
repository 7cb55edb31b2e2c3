/* Brittle damage that saturates exponentially (Miehe 1995, with a threshold and a critical damage).
 *
 *     drive      Y, the energy release rate
 *     threshold  Y <= kappa(d) = Y_D - Y_C ln(1 - d/d_inf), told by f(Y; d) = zeta(Y) - d <= 0, which keeps
 *                its digits as d comes near d_inf
 *     evolution  zeta(Y) = d_inf [1 - exp(-<Y - Y_D>/Y_C)], and 1 once this reaches d_c
 *
 * The curve alone comes near d_inf and never beyond; at the critical damage d_c of Lemaitre the rest breaks.
 * With d_inf < d_c the membrane never ruptures.  Associated law; dissipation Y dd/dt >= 0.
 * Y_C = 0 is the brittle limit: d_inf at once. */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { Y_D, Y_C, D_INF, D_C, N_PARAMS };

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
             .about = "energy release rate beyond Y_D at which damage is 63 % of d_inf",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
    [D_INF] = {.name = "d_inf",
               .unit = "1",
               .about = "damage that is approached",
               .flags = MLAW_OPEN_LO,
               .value = 1.0,
               .lo = 0.0,
               .hi = 1.0,
               .ok_lo = 0.0,
               .ok_hi = 1.0},
    [D_C] = {.name = "d_c",
             .unit = "1",
             .about = "critical damage, at which the rest breaks at once; 1: none",
             .flags = MLAW_OPEN_LO,
             .value = 0.99,
             .lo = 0.0,
             .hi = 1.0,
             .ok_lo = 0.2,
             .ok_hi = 1.0},
};

/* In place of a Y_C of 0: any excess that counts gives more than full damage, and 0/0 does not arise. */
static inline double hardening(double y_c) {
  return y_c > FLT_MIN ? y_c : FLT_MIN;
}

/* zeta and its slope at x = (Y - Y_D)/Y_C; below the threshold x < 0 goes on as it is, so that f < 0 there.
 */
typedef struct {
  double zeta, slope;
} Curve;

static inline Curve curve(double x, double d_inf, double d_c) {
  if (!(x > 0.0)) return (Curve){x, 1.0};
  const double zeta = -d_inf * expm1(-x);
  return zeta < d_c ? (Curve){zeta, d_inf * exp(-x)} : (Curve){1.0, 0.0};
}

static void evolve(const mlaw_damage_args *a, double *restrict zeta, double *restrict dzeta) {
  const double *Y = a->chan[MLAW_Y];
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C], d_inf = a->param[D_INF], d_c = a->param[D_C];
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double scale = hardening(mlaw_at(y_c, i));
    const Curve at = curve((Y[i] - mlaw_at(y_d, i)) / scale, mlaw_at(d_inf, i), mlaw_at(d_c, i));
    zeta[i] = at.zeta;
    if (dzeta) dzeta[i] = at.slope / scale;
  }
}

static int threshold(const mlaw_damage_args *a) {
  evolve(a, a->f, NULL);
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) a->f[i] -= a->d0[i];
  return MLAW_OK;
}

static int evolution(const mlaw_damage_args *a) {
  evolve(a, a->zeta, a->dzeta);
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "exponential",
    .title = "Brittle damage with exponential saturation",
    .source = "Miehe, Eur. J. Mech. A/Solids 14 (1995), with a threshold; critical damage: Lemaitre & "
              "Desmorat, Engineering Damage Mechanics (2005)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .needs = 1u << MLAW_Y,
    .threshold = threshold,
    .evolution = evolution,
};

static const mlaw_damage *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "exponential",
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
