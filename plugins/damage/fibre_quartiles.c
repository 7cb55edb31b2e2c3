/* Damage as the share of broken fibres in a bundle whose strength is known from a sample: least, quartiles
 * and greatest (Grandmaison et al. 2021, section 6.1, with a tabulated distribution). */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      Y, the energy release rate\n"
    "    threshold  f(Y; d) = P_f(Y) - d <= 0\n"
    "    evolution  zeta(Y) = P_f(Y) is piecewise linear:\n"
    "               0 at Y_0, 1/4 at Y_25, 1/2 at Y_50, 3/4 at Y_75, 1 at Y_100\n"
    "\n"
    "P_f is the share of fibres whose strength, the energy release rate at which a fibre breaks, is\n"
    "below Y.  Five values at equal distances are `marigo` with Y_D = Y_0 and Y_C = Y_100 - Y_0; two\n"
    "that coincide are a jump.\n"
    "\n"
    "Associated; dissipation Y dd/dt >= 0.\n";

enum { Y_0, Y_25, Y_50, Y_75, Y_100, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_0] = {MLAW_TENSION("Y_0", "strength: energy release rate at which the first fibre breaks"),
             .flags = MLAW_REQUIRED, MLAW_RANGE(0.0, INFINITY)},
    [Y_25] = {MLAW_TENSION("Y_25",
                           "strength: energy release rate at which a quarter of the fibres are broken"),
              .flags = MLAW_REQUIRED, MLAW_RANGE(0.0, INFINITY)},
    [Y_50] = {MLAW_TENSION("Y_50", "strength: energy release rate at which half of the fibres are broken"),
              .flags = MLAW_REQUIRED, MLAW_RANGE(0.0, INFINITY)},
    [Y_75] = {MLAW_TENSION("Y_75", "strength: energy release rate at which three quarters are broken"),
              .flags = MLAW_REQUIRED, MLAW_RANGE(0.0, INFINITY)},
    [Y_100] = {MLAW_TENSION("Y_100", "strength: energy release rate at which the last fibre breaks"),
               .flags = MLAW_REQUIRED, MLAW_RANGE(0.0, INFINITY)},
};

static int check(const double *param, mlaw_error *err) {
  for (int k = Y_0; k < Y_100; k++)
    if (param[k] > param[k + 1])
      return mlaw_fail(err, MLAW_BADPARAM, -1, "expected Y_0 <= Y_25 <= Y_50 <= Y_75 <= Y_100");
  return MLAW_OK;
}

/* Adds up the quarters of the distribution.  The first goes on below Y_0, where the share is negative and f
 * with it. */
static mlaw_curve curve(const mlaw_damage_args *a, ptrdiff_t i) {
  mlaw_curve at = {0.0, 0.0};
  for (int k = Y_0; k < Y_100; k++) {
    const double from = mlaw_at(a->param[k], i), width = mlaw_not_zero(mlaw_at(a->param[k + 1], i) - from);
    const double x = (a->chan[MLAW_Y][i] - from) / width;
    const int flat = x > 1.0 || (x < 0.0 && k > Y_0);
    at.zeta += 0.25 * (x > 1.0 ? 1.0 : flat ? 0.0 : x);
    if (!flat) at.slope += 0.25 / width;
  }
  return at;
}

static int threshold(const mlaw_damage_args *a) {
  return mlaw_curve_threshold(a, curve);
}

static int evolution(const mlaw_damage_args *a) {
  return mlaw_curve_evolution(a, curve);
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
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "fibre_quartiles", "1.0", "MIT", "the Capsella authors")
