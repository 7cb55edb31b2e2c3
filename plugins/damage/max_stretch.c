/* Damage by the largest principal stretch (Saint-Venant's criterion), with linear hardening. */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      L1, the larger principal stretch\n"
    "    threshold  L1 <= L_D + L_C d\n"
    "    evolution  d = <max L1 - L_D>/L_C\n"
    "\n"
    "L_C = 0 is the brittle limit: the first L1 beyond L_D breaks the point.\n"
    "\n"
    "Not associated, since L1 is not conjugate to d; dissipation Y dd/dt >= 0, since d never falls.\n";

enum { L_D, L_C, N_PARAMS };
enum { LARGEST, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [L_D] = {MLAW_NUMBER("L_D", "stretch at which damage starts"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(1.0, INFINITY)},
    [L_C] = {MLAW_NUMBER("L_C", "hardening: rupture at L_D + L_C"), .flags = MLAW_REQUIRED,
             MLAW_RANGE(0.0, INFINITY)},
};

/* History at each point: the largest drive so far. */
static const mlaw_var vars[N_VARS] = {
    [LARGEST] = {MLAW_NUMBER("L_max", "largest principal stretch so far"), .init = 1.0},
};

static double drive(const mlaw_damage_args *a, ptrdiff_t i) {
  return a->chan[MLAW_L1][i];
}

static int update(const mlaw_damage_args *a) {
  return mlaw_linear_hardening(a, drive, a->param[L_D], a->param[L_C]);
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "max_stretch",
    .title = "Damage by the largest stretch",
    .source = "Saint-Venant: largest elongation; hardening as in Marigo, C. R. Acad. Sci. II 292 (1981)",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .vars = vars,
    .n_vars = N_VARS,
    .var_size = sizeof(mlaw_var),
    .needs = 1u << MLAW_L1,
    .update = update,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "max_stretch", "1.0", "MIT", "the Capsella authors")
