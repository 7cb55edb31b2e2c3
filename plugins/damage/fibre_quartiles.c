/* Damage as the share of broken fibres in a bundle whose strength is known from a sample: least, quartiles
 * and greatest (Grandmaison et al. 2021, section 6.1, with a tabulated distribution).
 *
 *     drive      Y, the energy release rate
 *     threshold  f(Y; d) = P_f(Y) - d <= 0
 *     evolution  zeta(Y) = P_f(Y), linear from 0 at Y_0 to 1/4 at Y_25, 1/2 at Y_50, 3/4 at Y_75 and 1 at
 * Y_100
 *
 * Five values at equal distances are `marigo` with Y_D = Y_0 and Y_C = Y_100 - Y_0; two that coincide are a
 * jump.  Associated law; dissipation Y dd/dt >= 0. */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { Y_0, Y_25, Y_50, Y_75, Y_100, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_0] = {.name = "Y_0",
             .unit = "N/m",
             .about = "strength: energy release rate at which the first fibre breaks",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
    [Y_25] = {.name = "Y_25",
              .unit = "N/m",
              .about = "strength: energy release rate at which a quarter of the fibres are broken",
              .dim = {1, 0, -2},
              .flags = MLAW_REQUIRED,
              .lo = 0.0,
              .hi = INFINITY,
              .ok_lo = 0.0,
              .ok_hi = INFINITY},
    [Y_50] = {.name = "Y_50",
              .unit = "N/m",
              .about = "strength: energy release rate at which half of the fibres are broken",
              .dim = {1, 0, -2},
              .flags = MLAW_REQUIRED,
              .lo = 0.0,
              .hi = INFINITY,
              .ok_lo = 0.0,
              .ok_hi = INFINITY},
    [Y_75] = {.name = "Y_75",
              .unit = "N/m",
              .about = "strength: energy release rate at which three quarters are broken",
              .dim = {1, 0, -2},
              .flags = MLAW_REQUIRED,
              .lo = 0.0,
              .hi = INFINITY,
              .ok_lo = 0.0,
              .ok_hi = INFINITY},
    [Y_100] = {.name = "Y_100",
               .unit = "N/m",
               .about = "strength: energy release rate at which the last fibre breaks",
               .dim = {1, 0, -2},
               .flags = MLAW_REQUIRED,
               .lo = 0.0,
               .hi = INFINITY,
               .ok_lo = 0.0,
               .ok_hi = INFINITY},
};

static int check(const double *param, mlaw_error *err) {
  for (int k = Y_0; k < Y_100; k++)
    if (param[k] > param[k + 1])
      return mlaw_fail(err, MLAW_BADPARAM, -1, "expected Y_0 <= Y_25 <= Y_50 <= Y_75 <= Y_100");
  return MLAW_OK;
}

/* Adds quarter k of the distribution to the share of broken fibres.  The first goes on below Y_0, where the
 * share is negative and f with it. */
static inline void add_quarter(const mlaw_damage_args *a, int k, double *restrict zeta,
                               double *restrict dzeta) {
  const double *Y = a->chan[MLAW_Y];
  const mlaw_field from = a->param[k], to = a->param[k + 1];
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double distance = mlaw_at(to, i) - mlaw_at(from, i);
    const double width = distance > FLT_MIN ? distance : FLT_MIN;
    const double x = (Y[i] - mlaw_at(from, i)) / width;
    const int flat = x > 1.0 || (x < 0.0 && k > Y_0);
    zeta[i] += 0.25 * (x > 1.0 ? 1.0 : flat ? 0.0 : x);
    if (dzeta && !flat) dzeta[i] += 0.25 / width;
  }
}

static int evolve(const mlaw_damage_args *a, double *zeta, double *dzeta) {
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    zeta[i] = 0.0;
    if (dzeta) dzeta[i] = 0.0;
  }
  for (int k = Y_0; k < Y_100; k++) add_quarter(a, k, zeta, dzeta);
  return MLAW_OK;
}

static int evolution(const mlaw_damage_args *a) {
  return evolve(a, a->zeta, a->dzeta);
}

static int threshold(const mlaw_damage_args *a) {
  evolve(a, a->f, NULL);
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) a->f[i] -= a->d0[i];
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "fibre_quartiles",
    .title = "Bundle of fibres of sampled strength",
    .source = "Grandmaison et al. 2021, section 6.1, with a tabulated distribution",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .needs = 1u << MLAW_Y,
    .check = check,
    .threshold = threshold,
    .evolution = evolution,
};

static const mlaw_damage *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "fibre_quartiles",
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
