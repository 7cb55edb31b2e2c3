/* Damage by area dilation, as lipid membranes break (Evans, Waugh & Melnik 1976), with linear hardening. */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      alpha = J - 1 = l1 l2 - 1, the area strain; a smaller area does no harm\n"
    "    threshold  alpha <= alpha_D + alpha_C d\n"
    "    evolution  d = <max alpha - alpha_D>/alpha_C\n"
    "\n"
    "Red cells: lysis at an area strain of 0.02 to 0.06.  alpha_C = 0 is the brittle limit.\n"
    "\n"
    "Not associated, since alpha is not conjugate to d; dissipation Y dd/dt >= 0, since d never falls.\n";

enum { ALPHA_D, ALPHA_C, N_PARAMS };
enum { LARGEST, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [ALPHA_D] = {MLAW_NUMBER("alpha_D", "area strain at which damage starts"), .flags = MLAW_REQUIRED,
                 MLAW_RANGE(0.0, INFINITY)},
    [ALPHA_C] = {MLAW_NUMBER("alpha_C", "hardening: rupture at alpha_D + alpha_C"), .flags = MLAW_REQUIRED,
                 MLAW_RANGE(0.0, INFINITY)},
};

/* History at each point: the largest drive so far. */
static const mlaw_var vars[N_VARS] = {
    [LARGEST] = {MLAW_NUMBER("alpha_max", "largest area strain so far"), .init = 0.0},
};

/* sqrt(1 + I2) - 1, to all digits near rest. */
static double drive(const mlaw_damage_args *a, ptrdiff_t i) {
  const double I2 = a->chan[MLAW_I2][i];
  return I2 / (1.0 + sqrt(1.0 + I2));
}

static int update(const mlaw_damage_args *a) {
  return mlaw_linear_hardening(a, drive, a->param[ALPHA_D], a->param[ALPHA_C]);
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "area_dilation",
    .title = "Damage by area dilation",
    .source = "Evans, Waugh & Melnik, Biophys. J. 16 (1976): lysis of red cells at a limit of area strain; "
              "hardening as in Marigo 1981",
    .params = params,
    .n_params = N_PARAMS,
    .param_size = sizeof(mlaw_param),
    .vars = vars,
    .n_vars = N_VARS,
    .var_size = sizeof(mlaw_var),
    .needs = 1u << MLAW_I2,
    .update = update,
    .about = about,
};

MLAW_DAMAGE_PLUGIN(law, "area_dilation", "1.0", "MIT", "the Capsella authors")
