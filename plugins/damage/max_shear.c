/* Damage by the largest shear in the plane of the membrane (Tresca's criterion there), with linear hardening.
 *
 *     drive      S = (T1 - T2)/2 of the undamaged membrane: 0 under isotropic inflation
 *     threshold  S <= S_D + S_C d
 *     evolution  d = <max S - S_D>/S_C
 *
 * The shear across the wall, T1/2 where both tensions pull, is `rankine` with twice these parameters.  Not
 * associated, since S is not conjugate to d; dissipation Y dd/dt >= 0 since d never falls and Y >= 0.
 * S_C = 0 is the brittle limit: the first S beyond S_D breaks the point. */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { S_D, S_C, N_PARAMS };
enum { LARGEST, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [S_D] = {.name = "S_D",
             .unit = "N/m",
             .about = "shear tension at which damage starts",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
    [S_C] = {.name = "S_C",
             .unit = "N/m",
             .about = "hardening: rupture at S_D + S_C",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
};

/* History at each point: the largest drive so far. */
static const mlaw_var vars[N_VARS] = {
    [LARGEST] = {.name = "S_max",
                 .unit = "N/m",
                 .about = "largest in-plane shear tension so far",
                 .dim = {1, 0, -2},
                 .init = 0.0},
};

/* In place of a S_C of 0: any excess that counts gives more than full damage, and 0/0 does not arise. */
static inline double hardening(double s_c) {
  return s_c > FLT_MIN ? s_c : FLT_MIN;
}

static int update(const mlaw_damage_args *a) {
  const double *T1 = a->chan[MLAW_T1];
  const double *T2 = a->chan[MLAW_T2];
  const double *d0 = a->d0, *largest0 = a->state0;
  const mlaw_field onset = a->param[S_D], range = a->param[S_C];
  double *restrict largest = a->state1, *restrict d = a->d1;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double drive = 0.5 * (T1[i] - T2[i]);
    largest[i] = drive > largest0[i] ? drive : largest0[i];
    const double zeta = (largest[i] - mlaw_at(onset, i)) / hardening(mlaw_at(range, i));
    const double now = zeta < 1.0 ? zeta : 1.0;
    d[i] = now > d0[i] ? now : d0[i];
  }
  return MLAW_OK;
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
};

static const mlaw_damage *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "max_shear",
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
