/* Damage as the share of broken fibres in a bundle (Grandmaison et al. 2021, section 6.1) whose strengths,
 * energy release rates at which a fibre breaks, are of a log-normal distribution. */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      Y, the energy release rate\n"
    "    threshold  f(Y; d) = P_f(Y) - d <= 0\n"
    "    evolution  zeta(Y) = P_f(Y) = Phi(ln(x)/s), x = <Y - Y_D>/Y_50, and 1 once this reaches d_c\n"
    "\n"
    "P_f is the share of fibres whose strength, the energy release rate at which a fibre breaks, is\n"
    "below Y.  The distribution has no last fibre: when a share d_c is broken the rest cannot carry\n"
    "the load (Daniels 1945).  Phi is the normal distribution.  Y_50 = 0 is the brittle limit.\n"
    "\n"
    "Associated; dissipation Y dd/dt >= 0.\n";

enum { Y_D, Y_50, S, D_C, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_D] = {MLAW_TENSION("Y_D", "energy release rate below which every fibre is sound"), .value = 0.0,
             MLAW_RANGE(0.0, INFINITY)},
    [Y_50] = {MLAW_TENSION("Y_50", "median strength beyond Y_D"), .flags = MLAW_REQUIRED,
              MLAW_RANGE(0.0, INFINITY)},
    [S] = {MLAW_NUMBER("s", "standard deviation of the logarithm of the strength"),
           .flags = MLAW_REQUIRED | MLAW_OPEN_LO, MLAW_WITHIN(0.0, INFINITY), MLAW_FITTED(0.05, 2.0)},
    [D_C] = {MLAW_NUMBER("d_c", "share at which the rest breaks at once; 1: never"), .flags = MLAW_OPEN_LO,
             .value = 0.99, MLAW_WITHIN(0.0, 1.0), MLAW_FITTED(0.2, 1.0)},
};

static const double ROOT_2 = 1.4142135623730951, ROOT_2_PI = 2.5066282746310002;

/* The rest breaks at the share d_c.  Below Y_D the share goes on as x < 0, so that f is negative there. */
static mlaw_curve curve(const mlaw_damage_args *a, ptrdiff_t i) {
  const double s = mlaw_at(a->param[S], i), scale = mlaw_not_zero(mlaw_at(a->param[Y_50], i));
  const double x = (a->chan[MLAW_Y][i] - mlaw_at(a->param[Y_D], i)) / scale;
  const double z = x > 0.0 ? log(x) / s : 0.0, broken = x > 0.0 ? 0.5 * erfc(-z / ROOT_2) : x;
  if (broken >= mlaw_at(a->param[D_C], i)) return (mlaw_curve){1.0, 0.0};
  return (mlaw_curve){broken, (x > 0.0 ? exp(-0.5 * z * z) / (x * s * ROOT_2_PI) : 1.0) / scale};
}

static int threshold(const mlaw_damage_args *a) {
  return mlaw_curve_threshold(a, curve);
}

static int evolution(const mlaw_damage_args *a) {
  return mlaw_curve_evolution(a, curve);
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "fibre_log_normal",
    .title = "Bundle of fibres of log-normal strength",
    .source = "Daniels, Proc. R. Soc. A 183 (1945); Grandmaison et al. 2021, section 6.1",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .needs = 1u << MLAW_Y,
    .threshold = threshold,
    .evolution = evolution,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "fibre_log_normal", "1.0", "MIT", "the Capsella authors")
