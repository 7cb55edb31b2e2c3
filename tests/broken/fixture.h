/* What the fixtures share: a sound energy law and a sound damage law, to be spoilt in one place each.  A
 * fixture sets ENERGY or DAMAGE functions, describes its law, and hands it to PLUGIN. */
#ifndef CAPSELLA_TESTS_BROKEN_FIXTURE_H
#define CAPSELLA_TESTS_BROKEN_FIXTURE_H

#include <math.h>
#include <mlaw/mlaw.h>

/* phi = G_s/2 (I1 - I2/(1 + I2)): neo-Hookean. */
static inline int sound_eval(const mlaw_energy_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) {
    const double G = mlaw_at(a->param[0], i), u = 1.0 / (1.0 + a->I2[i]);
    if (a->phi) a->phi[i] = 0.5 * G * (a->I1[i] - a->I2[i] * u);
    if (a->dphi) {
      a->dphi[i] = 0.5 * G;
      a->dphi[a->ld + i] = -0.5 * G * u * u;
    }
    if (a->d2phi) {
      a->d2phi[i] = a->d2phi[a->ld + i] = 0.0;
      a->d2phi[2 * a->ld + i] = G * u * u * u;
    }
  }
  return MLAW_OK;
}

/* f = Y - (Y_D + d), zeta = Y - Y_D */
static inline int sound_threshold(const mlaw_damage_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) a->f[i] = a->chan[MLAW_Y][i] - mlaw_at(a->param[0], i) - a->d0[i];
  return MLAW_OK;
}
static inline int sound_evolution(const mlaw_damage_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) {
    a->zeta[i] = a->chan[MLAW_Y][i] - mlaw_at(a->param[0], i);
    if (a->dzeta) a->dzeta[i] = 1.0;
  }
  return MLAW_OK;
}

#define ONE_PARAMETER(symbol)                                                                                \
  static const mlaw_param params[] = {{.name = symbol,                                                       \
                                       .unit = "N/m",                                                        \
                                       .about = "the parameter",                                             \
                                       .dim = {1, 0, -2},                                                    \
                                       .flags = MLAW_OPEN_LO,                                                \
                                       .value = 1.0,                                                         \
                                       .lo = 0.0,                                                            \
                                       .hi = INFINITY,                                                       \
                                       .ok_lo = 0.0,                                                         \
                                       .ok_hi = INFINITY}}

/* Fields of a law of either kind that are alike in all fixtures. */
#define ALIKE(type, name)                                                                                    \
  .size = sizeof(type), .id = name, .title = "Fixture", .source = "none", .params = params, .n_params = 1,   \
  .param_size = sizeof(mlaw_param)

#define PLUGIN_HEAD(name)                                                                                    \
  .size = sizeof(mlaw_plugin), .abi_minor = MLAW_ABI_MINOR, .id = name, .version = "1", .license = "MIT",    \
  .author = "nobody"

#define ENTRY(answer)                                                                                        \
  const mlaw_plugin *mlaw_plugin_v1(uint32_t host_minor) {                                                   \
    (void)host_minor;                                                                                        \
    return answer;                                                                                           \
  }

#define ENERGY_PLUGIN(name)                                                                                  \
  static const mlaw_energy *const laws[] = {&law};                                                           \
  static const mlaw_plugin plugin = {PLUGIN_HEAD(name), .n_energy = 1, .energy = laws};                      \
  ENTRY(&plugin)

#define DAMAGE_PLUGIN(name)                                                                                  \
  static const mlaw_damage *const laws[] = {&law};                                                           \
  static const mlaw_plugin plugin = {PLUGIN_HEAD(name), .n_damage = 1, .damage = laws};                      \
  ENTRY(&plugin)

#endif
