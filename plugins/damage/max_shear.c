/* Damage by the largest shear in the plane of the membrane (Tresca's criterion there), with linear
 * hardening. */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      S = (T1 - T2)/2 of the undamaged membrane: 0 under isotropic inflation\n"
    "    threshold  S <= S_D + S_C d\n"
    "    evolution  d = <max S - S_D>/S_C\n"
    "\n"
    "The shear across the wall, T1/2 where both tensions pull, is `rankine` with twice these\n"
    "parameters.  S_C = 0 is the brittle limit: the first S beyond S_D breaks the point.\n"
    "\n"
    "Not associated, since S is not conjugate to d; dissipation Y dd/dt >= 0, since d never falls.\n";

enum { S_D, S_C, N_PARAMS };
enum { LARGEST, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [S_D] = {MLAW_TENSION("S_D", "shear tension at which damage starts"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
    [S_C] = {MLAW_TENSION("S_C", "hardening: rupture at S_D + S_C"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
};

/* History at each point: the largest drive so far. */
static const mlaw_var vars[N_VARS] = {
    [LARGEST] = {MLAW_TENSION("S_max", "largest in-plane shear tension so far"), .init = 0.0},
};

static double drive(const mlaw_damage_args *a, ptrdiff_t i) {
  return 0.5 * (a->chan[MLAW_T1][i] - a->chan[MLAW_T2][i]);
}

static int update(const mlaw_damage_args *a) {
  return mlaw_linear_hardening(a, drive, a->param[S_D], a->param[S_C]);
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "max_shear",
    .title = "Damage by the largest in-plane shear",
    .source =
        "Tresca (1864): largest shear stress, in the plane of the membrane; hardening as in Marigo 1981",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .vars = vars,
    .n_vars = N_VARS,
    .var_size = sizeof(mlaw_var),
    .needs = 1u << MLAW_T1 | 1u << MLAW_T2,
    .update = update,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "max_shear", "1.0", "MIT", "the Capsella authors")
