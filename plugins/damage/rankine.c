/* Damage by the largest principal tension (Rankine's criterion), with linear hardening. */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      T1, the larger principal tension of the undamaged membrane; compression does no harm\n"
    "    threshold  T1 <= T_D + T_C d\n"
    "    evolution  d = <max T1 - T_D>/T_C\n"
    "\n"
    "T_C = 0 is the brittle limit: the first T1 beyond T_D breaks the point.\n"
    "\n"
    "Not associated, since T1 is not conjugate to d; dissipation Y dd/dt >= 0, since d never falls.\n";

enum { T_D, T_C, N_PARAMS };
enum { LARGEST, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [T_D] = {MLAW_TENSION("T_D", "tension at which damage starts"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
    [T_C] = {MLAW_TENSION("T_C", "hardening: rupture at T_D + T_C"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
};

/* History at each point: the largest drive so far. */
static const mlaw_var vars[N_VARS] = {
    [LARGEST] = {MLAW_TENSION("T_max", "largest principal tension so far"), .init = 0.0},
};

static double drive(const mlaw_damage_args *a, ptrdiff_t i) {
  return a->chan[MLAW_T1][i];
}

static int update(const mlaw_damage_args *a) {
  return mlaw_linear_hardening(a, drive, a->param[T_D], a->param[T_C]);
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "rankine",
    .title = "Damage by the largest principal tension",
    .source =
        "Rankine (1857): largest principal stress; hardening as in Marigo, C. R. Acad. Sci. II 292 (1981)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .vars = vars,
    .n_vars = N_VARS,
    .var_size = sizeof(mlaw_var),
    .needs = 1u << MLAW_T1,
    .update = update,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "rankine", "1.0", "MIT", "the Capsella authors")
