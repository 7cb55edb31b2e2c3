/* Damage by area dilation, as lipid membranes break (Evans, Waugh & Melnik 1976), with linear hardening.
 *
 *     drive      alpha = J - 1 = l1 l2 - 1, the area strain; a smaller area does no harm
 *     threshold  alpha <= alpha_D + alpha_C d
 *     evolution  d = <max alpha - alpha_D>/alpha_C
 *
 * Red cells: lysis at an area strain of 0.02 to 0.06.  Not associated, since alpha is not conjugate to d;
 * dissipation Y dd/dt >= 0 since d never falls and Y >= 0.  alpha_C = 0 is the brittle limit. */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { ALPHA_D, ALPHA_C, N_PARAMS };
enum { LARGEST, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [ALPHA_D] = {.name = "alpha_D",
                 .unit = "1",
                 .about = "area strain at which damage starts",
                 .flags = MLAW_REQUIRED,
                 .lo = 0.0,
                 .hi = INFINITY,
                 .ok_lo = 0.0,
                 .ok_hi = INFINITY},
    [ALPHA_C] = {.name = "alpha_C",
                 .unit = "1",
                 .about = "hardening: rupture at alpha_D + alpha_C",
                 .flags = MLAW_REQUIRED,
                 .lo = 0.0,
                 .hi = INFINITY,
                 .ok_lo = 0.0,
                 .ok_hi = INFINITY},
};

/* History at each point: the largest drive so far. */
static const mlaw_var vars[N_VARS] = {
    [LARGEST] = {.name = "alpha_max", .unit = "1", .about = "largest area strain so far", .init = 0.0},
};

/* In place of a ALPHA_C of 0: any excess that counts gives more than full damage, and 0/0 does not arise. */
static inline double hardening(double alpha_c) {
  return alpha_c > FLT_MIN ? alpha_c : FLT_MIN;
}

/* sqrt(1 + I2) - 1, to all digits near rest. */
static inline double area_strain(double I2) {
  return I2 / (1.0 + sqrt(1.0 + I2));
}

static int update(const mlaw_damage_args *a) {
  const double *I2 = a->chan[MLAW_I2];
  const double *d0 = a->d0, *largest0 = a->state0;
  const mlaw_field onset = a->param[ALPHA_D], range = a->param[ALPHA_C];
  double *restrict largest = a->state1, *restrict d = a->d1;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double drive = area_strain(I2[i]);
    largest[i] = drive > largest0[i] ? drive : largest0[i];
    const double zeta = (largest[i] - mlaw_at(onset, i)) / hardening(mlaw_at(range, i));
    const double now = zeta < 1.0 ? zeta : 1.0;
    d[i] = now > d0[i] ? now : d0[i];
  }
  return MLAW_OK;
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
};

static const mlaw_damage *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "area_dilation",
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
