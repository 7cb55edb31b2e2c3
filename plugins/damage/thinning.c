/* Damage by thinning of the wall, which keeps its volume, with linear hardening: do capsules break where they
 * are thinnest, as Chang & Olbricht (1993) saw?
 *
 *     drive      eta = 1 - h/h0 = 1 - 1/(l1 l2), the share of the thickness that is lost, below 1
 *     threshold  eta <= eta_D + eta_C d
 *     evolution  d = <max eta - eta_D>/eta_C
 *
 * eta grows with the area strain alpha, eta = alpha/(1 + alpha): the place of onset is that of area_dilation.
 * No stretch reaches eta_D + eta_C >= 1, which thus excludes rupture.  Not associated, since eta is not
 * conjugate to d; dissipation Y dd/dt >= 0 since d never falls and Y >= 0.  eta_C = 0 is the brittle limit.
 */
#include <float.h>
#include <math.h>
#include <mlaw/mlaw.h>

enum { ETA_D, ETA_C, N_PARAMS };
enum { LARGEST, N_VARS };

static const mlaw_param params[N_PARAMS] = {
    [ETA_D] = {.name = "eta_D",
               .unit = "1",
               .about = "share of the thickness lost at which damage starts",
               .flags = MLAW_REQUIRED,
               .lo = 0.0,
               .hi = 1.0,
               .ok_lo = 0.0,
               .ok_hi = 1.0},
    [ETA_C] = {.name = "eta_C",
               .unit = "1",
               .about = "hardening: rupture at eta_D + eta_C",
               .flags = MLAW_REQUIRED,
               .lo = 0.0,
               .hi = INFINITY,
               .ok_lo = 0.0,
               .ok_hi = 1.0},
};

/* History at each point: the largest drive so far. */
static const mlaw_var vars[N_VARS] = {
    [LARGEST] = {.name = "eta_max",
                 .unit = "1",
                 .about = "largest share of the thickness lost so far",
                 .init = 0.0},
};

/* In place of a ETA_C of 0: any excess that counts gives more than full damage, and 0/0 does not arise. */
static inline double hardening(double eta_c) {
  return eta_c > FLT_MIN ? eta_c : FLT_MIN;
}

/* 1 - 1/sqrt(1 + I2), to all digits near rest. */
static inline double thickness_lost(double I2) {
  const double J = sqrt(1.0 + I2);
  return I2 / (J * (1.0 + J));
}

static int update(const mlaw_damage_args *a) {
  const double *I2 = a->chan[MLAW_I2];
  const double *d0 = a->d0, *largest0 = a->state0;
  const mlaw_field onset = a->param[ETA_D], range = a->param[ETA_C];
  double *restrict largest = a->state1, *restrict d = a->d1;
  for (ptrdiff_t i = 0; i < (ptrdiff_t)a->n; i++) {
    const double drive = thickness_lost(I2[i]);
    largest[i] = drive > largest0[i] ? drive : largest0[i];
    const double zeta = (largest[i] - mlaw_at(onset, i)) / hardening(mlaw_at(range, i));
    const double now = zeta < 1.0 ? zeta : 1.0;
    d[i] = now > d0[i] ? now : d0[i];
  }
  return MLAW_OK;
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
};

static const mlaw_damage *const laws[] = {&law};

static const mlaw_plugin plugin = {
    .size = sizeof(mlaw_plugin),
    .abi_minor = MLAW_ABI_MINOR,
    .id = "thinning",
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
