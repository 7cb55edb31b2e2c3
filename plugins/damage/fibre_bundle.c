/* Damage as the share of broken fibres in a bundle (Grandmaison et al. 2021, section 6.1) whose strengths,
 * energy release rates at which a fibre breaks, are spread evenly from Y_D to Y_D + Y_C. */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      Y, the energy release rate\n"
    "    threshold  f(Y; d) = P_f(Y) - d <= 0\n"
    "    evolution  zeta(Y) = P_f(Y) = (Y - Y_D)/Y_C\n"
    "\n"
    "P_f is the share of fibres whose strength, the energy release rate at which a fibre breaks, is\n"
    "below Y.  This is `marigo` seen from its fibres, with the same bits; `fibre_weibull`,\n"
    "`fibre_log_normal` and `fibre_quartiles` are bundles of other strengths.  Y_C = 0, no scatter, is\n"
    "the brittle limit.\n"
    "\n"
    "Associated; dissipation Y dd/dt >= 0.\n";

enum { Y_D, Y_C, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_D] = {MLAW_TENSION("Y_D", "strength of the first fibre"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
    [Y_C] = {MLAW_TENSION("Y_C", "scatter of strength: the last fibre breaks at Y_D + Y_C"),
             .flags = MLAW_REQUIRED, MLAW_RANGE(0.0, INFINITY)},
};

/* Share of fibres whose strength is below Y; negative below the first. */
static mlaw_curve curve(const mlaw_damage_args *a, ptrdiff_t i) {
  const double scatter = mlaw_not_zero(mlaw_at(a->param[Y_C], i));
  return (mlaw_curve){(a->chan[MLAW_Y][i] - mlaw_at(a->param[Y_D], i)) / scatter, 1.0 / scatter};
}

static int threshold(const mlaw_damage_args *a) {
  return mlaw_curve_threshold(a, curve);
}

static int evolution(const mlaw_damage_args *a) {
  return mlaw_curve_evolution(a, curve);
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
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "fibre_bundle", "1.0", "MIT", "the Capsella authors")
