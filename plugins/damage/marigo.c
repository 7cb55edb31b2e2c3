/* Marigo's brittle damage with linear hardening (Marigo 1981; Grandmaison et al. 2021, eq. 2.27-2.31).
 *
 *     f(Y; d) = Y - kappa(d) <= 0,   kappa(d) = Y_D + Y_C d,   zeta(Y) = (Y - Y_D)/Y_C
 *
 * Dissipation Y dd/dt >= 0.  Y_C = 0 is the brittle limit: the first Y beyond Y_D breaks the point. */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { Y_D, Y_C, N_PARAMS };

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
             .about = "hardening modulus: rupture at Y_D + Y_C",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
};

/* In place of a Y_C of 0: any excess that counts gives more than full damage, and 0/0 does not arise. */
static inline double hardening(double y_c) {
  return y_c > FLT_MIN ? y_c : FLT_MIN;
}

static int threshold(const mlaw_damage_args *a) {
  const double *Y = a->chan[MLAW_Y], *d = a->d0;
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C];
  double *restrict f = a->f;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) f[i] = Y[i] - (mlaw_at(y_d, i) + mlaw_at(y_c, i) * d[i]);
  return MLAW_OK;
}

static int evolution(const mlaw_damage_args *a) {
  const double *Y = a->chan[MLAW_Y];
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C];
  const ptrdiff_t n = (ptrdiff_t)a->n;
  double *restrict zeta = a->zeta;
  for (ptrdiff_t i = 0; i < n; i++) zeta[i] = (Y[i] - mlaw_at(y_d, i)) / hardening(mlaw_at(y_c, i));
  if (a->dzeta) {
    double *restrict dzeta = a->dzeta;
    for (ptrdiff_t i = 0; i < n; i++) dzeta[i] = 1.0 / hardening(mlaw_at(y_c, i));
  }
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "marigo",
    .title = "Brittle damage with linear hardening",
    .source = "Marigo, C. R. Acad. Sci. II 292 (1981); Grandmaison et al. 2021, eq. 2.27-2.31",
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
    .id = "marigo",
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
