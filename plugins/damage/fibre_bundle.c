/* Damage as the share of broken fibres in a bundle (Grandmaison et al. 2021, section 6.1) whose strengths,
 * energy release rates at which a fibre breaks, are spread evenly from Y_D to Y_D + Y_C.
 *
 *     drive      Y, the energy release rate
 *     threshold  f(Y; d) = P_f(Y) - d <= 0
 *     evolution  zeta(Y) = P_f(Y) = (Y - Y_D)/Y_C
 *
 * This is `marigo` seen from its fibres, with the same bits.  fibre_weibull, fibre_log_normal and
 * fibre_quartiles are bundles of other strengths.  Associated law; dissipation Y dd/dt >= 0.  Y_C = 0, no
 * scatter, is the brittle limit. */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { Y_D, Y_C, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_D] = {.name = "Y_D",
             .unit = "N/m",
             .about = "strength of the first fibre",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
    [Y_C] = {.name = "Y_C",
             .unit = "N/m",
             .about = "scatter of strength: the last fibre breaks at Y_D + Y_C",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
};

/* In place of a Y_C of 0: any excess that counts breaks all fibres, and 0/0 does not arise. */
static inline double scatter(double y_c) {
  return y_c > FLT_MIN ? y_c : FLT_MIN;
}

/* Share of fibres whose strength is below Y; negative below the first. */
static void broken(const mlaw_damage_args *a, double *restrict share) {
  const double *Y = a->chan[MLAW_Y];
  const mlaw_field y_d = a->param[Y_D], y_c = a->param[Y_C];
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++)
    share[i] = (Y[i] - mlaw_at(y_d, i)) / scatter(mlaw_at(y_c, i));
}

static int threshold(const mlaw_damage_args *a) {
  broken(a, a->f);
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) a->f[i] -= a->d0[i];
  return MLAW_OK;
}

static int evolution(const mlaw_damage_args *a) {
  broken(a, a->zeta);
  if (a->dzeta)
    for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) a->dzeta[i] = 1.0 / scatter(mlaw_at(a->param[Y_C], i));
  return MLAW_OK;
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "fibre_bundle",
    .title = "Bundle of fibres of evenly spread strength",
    .source = "Grandmaison et al. 2021, eq. 6.1-6.4",
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
    .id = "fibre_bundle",
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
