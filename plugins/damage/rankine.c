/* Damage by the largest principal tension (Rankine's criterion), with linear hardening.
 *
 *     drive      T1, the larger principal tension of the undamaged membrane; compression does no harm
 *     threshold  T1 <= T_D + T_C d
 *     evolution  d = <max T1 - T_D>/T_C
 *
 * Not associated, since T1 is not conjugate to d; dissipation Y dd/dt >= 0 since d never falls and Y >= 0.
 * T_C = 0 is the brittle limit: the first T1 beyond T_D breaks the point. */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { T_D, T_C, N_PARAMS };
enum { LARGEST, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [T_D] = {.name = "T_D",
             .unit = "N/m",
             .about = "tension at which damage starts",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
    [T_C] = {.name = "T_C",
             .unit = "N/m",
             .about = "hardening: rupture at T_D + T_C",
             .dim = {1, 0, -2},
             .flags = MLAW_REQUIRED,
             .lo = 0.0,
             .hi = INFINITY,
             .ok_lo = 0.0,
             .ok_hi = INFINITY},
};

/* History at each point: the largest drive so far. */
static const mlaw_var vars[N_VARS] = {
    [LARGEST] = {.name = "T_max",
                 .unit = "N/m",
                 .about = "largest principal tension so far",
                 .dim = {1, 0, -2},
                 .init = 0.0},
};

/* In place of a T_C of 0: any excess that counts gives more than full damage, and 0/0 does not arise. */
static inline double hardening(double t_c) {
  return t_c > FLT_MIN ? t_c : FLT_MIN;
}

static int update(const mlaw_damage_args *a) {
  const double *T1 = a->chan[MLAW_T1];
  const double *d0 = a->d0, *largest0 = a->state0;
  const mlaw_field onset = a->param[T_D], range = a->param[T_C];
  double *restrict largest = a->state1, *restrict d = a->d1;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double drive = T1[i];
    largest[i] = drive > largest0[i] ? drive : largest0[i];
    const double zeta = (largest[i] - mlaw_at(onset, i)) / hardening(mlaw_at(range, i));
    const double now = zeta < 1.0 ? zeta : 1.0;
    d[i] = now > d0[i] ? now : d0[i];
  }
  return MLAW_OK;
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
};

static const mlaw_damage *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "rankine",
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
