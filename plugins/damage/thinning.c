/* Damage by thinning of the wall, which keeps its volume, with linear hardening: do capsules break where
 * they are thinnest, as Chang & Olbricht (1993) saw? */
#include <mlaw/brief.h>

static const char about[] =
    "    drive      eta = 1 - h/h0 = 1 - 1/(l1 l2), the share of the thickness that is lost, below 1\n"
    "    threshold  eta <= eta_D + eta_C d\n"
    "    evolution  d = <max eta - eta_D>/eta_C\n"
    "\n"
    "The wall keeps its volume.  eta grows with the area strain alpha, eta = alpha/(1 + alpha): the\n"
    "place of onset is that of `area_dilation`.  No stretch reaches eta_D + eta_C of 1 or more, which\n"
    "thus excludes rupture.  eta_C = 0 is the brittle limit.\n"
    "\n"
    "Not associated, since eta is not conjugate to d; dissipation Y dd/dt >= 0, since d never falls.\n";

enum { ETA_D, ETA_C, N_PARAMS };
enum { LARGEST, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [ETA_D] = {MLAW_NUMBER("eta_D", "share of the thickness lost at which damage starts"),
               .flags = MLAW_REQUIRED, MLAW_RANGE(0.0, 1.0)},
    [ETA_C] = {MLAW_NUMBER("eta_C", "hardening: rupture at eta_D + eta_C"), .flags = MLAW_REQUIRED,
               MLAW_WITHIN(0.0, INFINITY), MLAW_FITTED(0.0, 1.0)},
};

/* History at each point: the largest drive so far. */
static const mlaw_var vars[N_VARS] = {
    [LARGEST] = {MLAW_NUMBER("eta_max", "largest share of the thickness lost so far"), .init = 0.0},
};

/* 1 - 1/sqrt(1 + I2), to all digits near rest. */
static double drive(const mlaw_damage_args *a, ptrdiff_t i) {
  const double I2 = a->chan[MLAW_I2][i], J = sqrt(1.0 + I2);
  return I2 / (J * (1.0 + J));
}

static int update(const mlaw_damage_args *a) {
  return mlaw_linear_hardening(a, drive, a->param[ETA_D], a->param[ETA_C]);
}

static const mlaw_damage law = {
    .size = sizeof(mlaw_damage),
    .id = "thinning",
    .title = "Damage by thinning of the wall",
    .source = "Chang & Olbricht, J. Fluid Mech. 250 (1993): capsules break where the wall is thinnest; "
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

MLAW_DAMAGE_PLUGIN(law, "thinning", "1.0", "MIT", "the Capsella authors")
