/* Brittle damage that saturates exponentially (Miehe 1995, with a threshold and a critical damage). */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      Y, the energy release rate\n"
    "    threshold  Y <= kappa(d) = Y_D - Y_C ln(1 - d/d_inf)\n"
    "    evolution  zeta(Y) = d_inf [1 - exp(-<Y - Y_D>/Y_C)], and 1 once this reaches d_c\n"
    "\n"
    "The curve alone comes near d_inf and never beyond; at the critical damage d_c of Lemaitre the\n"
    "rest breaks.  With d_inf < d_c the membrane never ruptures.  The threshold is told by f(Y; d) =\n"
    "zeta(Y) - d <= 0, which keeps its digits as d comes near d_inf.  Y_C = 0 is the brittle limit:\n"
    "d_inf at once.\n"
    "\n"
    "Associated; dissipation Y dd/dt >= 0.\n";

enum { Y_D, Y_C, D_INF, D_C, N_PARAMS };

static const mlaw_param params[N_PARAMS] = {
    [Y_D] = {MLAW_TENSION("Y_D", "energy release rate at which damage starts"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
    [Y_C] = {MLAW_TENSION("Y_C", "energy release rate beyond Y_D at which damage is 63 % of d_inf"),
             .flags = MLAW_REQUIRED, MLAW_RANGE(0.0, INFINITY)},
    [D_INF] = {MLAW_NUMBER("d_inf", "damage that is approached"), .flags = MLAW_OPEN_LO, .value = 1.0,
               MLAW_RANGE(0.0, 1.0)},
    [D_C] = {MLAW_NUMBER("d_c", "critical damage, at which the rest breaks at once; 1: none"),
             .flags = MLAW_OPEN_LO, .value = 0.99, MLAW_WITHIN(0.0, 1.0), MLAW_FITTED(0.2, 1.0)},
};

/* Below the threshold x < 0 goes on as it is, so that f < 0 there. */
static mlaw_curve curve(const mlaw_damage_args *a, ptrdiff_t i) {
  const double scale = mlaw_not_zero(mlaw_at(a->param[Y_C], i)), d_inf = mlaw_at(a->param[D_INF], i);
  const double x = (a->chan[MLAW_Y][i] - mlaw_at(a->param[Y_D], i)) / scale;
  if (!(x > 0.0)) return (mlaw_curve){x, 1.0 / scale};
  const double zeta = -d_inf * expm1(-x);
  return zeta < mlaw_at(a->param[D_C], i) ? (mlaw_curve){zeta, d_inf * exp(-x) / scale}
                                          : (mlaw_curve){1.0, 0.0};
}

static int threshold(const mlaw_damage_args *a) {
  return mlaw_curve_threshold(a, curve);
}

static int evolution(const mlaw_damage_args *a) {
  return mlaw_curve_evolution(a, curve);
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
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "exponential", "1.0", "MIT", "the Capsella authors")
