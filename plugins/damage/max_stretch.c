/* Damage by the largest principal stretch (Saint-Venant's criterion), with linear hardening.
 *
 *     drive      L1, the larger principal stretch
 *     threshold  L1 <= L_D + L_C d
 *     evolution  d = <max L1 - L_D>/L_C
 *
 * Not associated, since L1 is not conjugate to d; dissipation Y dd/dt >= 0 since d never falls and Y >= 0.
 * L_C = 0 is the brittle limit: the first L1 beyond L_D breaks the point. */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { L_D, L_C, N_PARAMS };
enum { LARGEST, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [L_D] = {.name = "L_D",
             .unit = "1",
             .about = "stretch at which damage starts",
             .flags = MLAW_REQUIRED,
             .lo = 1.0,
             .hi = INFINITY,
             .ok_lo = 1.0,
             .ok_hi = INFINITY},
    [L_C] = {.name = "L_C",
             .unit = "1",
             .about = "hardening: rupture at L_D + L_C",
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
};

/* History at each point: the largest drive so far. */
static const mlaw_var vars[N_VARS] = {
    [LARGEST] = {.name = "L_max", .unit = "1", .about = "largest principal stretch so far", .init = 1.0},
};

/* In place of a L_C of 0: any excess that counts gives more than full damage, and 0/0 does not arise. */
static inline double hardening(double l_c) {
  return l_c > FLT_MIN ? l_c : FLT_MIN;
}

static int update(const mlaw_damage_args *a) {
  const double *L1 = a->chan[MLAW_L1];
  const double *d0 = a->d0, *largest0 = a->state0;
  const mlaw_field onset = a->param[L_D], range = a->param[L_C];
  double *restrict largest = a->state1, *restrict d = a->d1;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double drive = L1[i];
    largest[i] = drive > largest0[i] ? drive : largest0[i];
    const double zeta = (largest[i] - mlaw_at(onset, i)) / hardening(mlaw_at(range, i));
    const double now = zeta < 1.0 ? zeta : 1.0;
    d[i] = now > d0[i] ? now : d0[i];
  }
  return MLAW_OK;
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
};

static const mlaw_damage *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "max_stretch",
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
