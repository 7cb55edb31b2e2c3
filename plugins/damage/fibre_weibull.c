/* Damage as the share of broken fibres in a bundle (Grandmaison et al. 2021, section 6.1) whose strengths,
 * energy release rates at which a fibre breaks, are of a Weibull distribution (1951).
 *
 *     drive      Y, the energy release rate
 *     threshold  f(Y; d) = P_f(Y) - d <= 0
 *     evolution  zeta(Y) = P_f(Y) = 1 - exp(-x^m), x = <Y - Y_D>/Y_0, and 1 once this reaches d_c
 *
 * The distribution has no last fibre: when a share d_c is broken the rest cannot carry the load (Daniels
 * 1945).  Y_0 = 0 is the brittle limit.  Associated law; dissipation Y dd/dt >= 0. */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { Y_D, Y_0, M, D_C, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_D] = {.name = "Y_D",
             .unit = "N/m",
             .about = "energy release rate below which every fibre is sound",
             .dim = {1, 0, -2},
             .value = 0.0,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
    [Y_0] = {.name = "Y_0",
             .unit = "N/m",
             .about = "strength beyond Y_D at which 63 % of the fibres are broken",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
    [M] = {.name = "m",
           .unit = "1",
           .about = "Weibull modulus: the larger, the less scatter",
           .flags = MLAW_REQUIRED | MLAW_OPEN_LO,
           .lo = 0.0,
           .hi = INFINITY,
           .ok_lo = 0.5,
           .ok_hi = 30.0},
    [D_C] = {.name = "d_c",
             .unit = "1",
             .about = "share at which the rest breaks at once; 1: never",
             .flags = MLAW_OPEN_LO,
             .value = 0.99,
             .lo = 0.0,
             .hi = 1.0,
             .ok_lo = 0.2,
             .ok_hi = 1.0},
};

/* Share of broken fibres at x > 0, and its slope. */
typedef struct {
  double broken, density;
} Share;

static inline Share weibull(double x, double m) {
  const double p = pow(x, m);
  return (Share){-expm1(-p), p < 700.0 ? m / x * p * exp(-p) : 0.0};
}

/* The rest breaks at the share d_c.  Below Y_D the share goes on as x < 0, so that f is negative there. */
static void evolve(const mlaw_damage_args *a, double *restrict zeta, double *restrict dzeta) {
  const double *Y = a->chan[MLAW_Y];
  const mlaw_field y_d = a->param[Y_D], spread = a->param[Y_0], shape = a->param[M], d_c = a->param[D_C];
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double scale = mlaw_at(spread, i) > FLT_MIN ? mlaw_at(spread, i) : FLT_MIN;
    const double x = (Y[i] - mlaw_at(y_d, i)) / scale;
    Share share = x > 0.0 ? weibull(x, mlaw_at(shape, i)) : (Share){x, 1.0};
    if (share.broken >= mlaw_at(d_c, i)) share = (Share){1.0, 0.0};
    zeta[i] = share.broken;
    if (dzeta) dzeta[i] = share.density / scale;
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
    .id = "fibre_weibull",
    .title = "Bundle of fibres of Weibull strength",
    .source = "Weibull, J. Appl. Mech. 18 (1951); Daniels, Proc. R. Soc. A 183 (1945); Grandmaison et al. "
              "2021, section 6.1",
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
    .id = "fibre_weibull",
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
