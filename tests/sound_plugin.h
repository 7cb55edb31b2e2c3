/* The tables of a plugin in which nothing is wrong, for tests that spoil one thing in them. */
#ifndef CAPSELLA_TESTS_SOUND_PLUGIN_H
#define CAPSELLA_TESTS_SOUND_PLUGIN_H

#include <math.h>
#include <mlaw/mlaw.h>

static inline int sound_eval(const mlaw_energy_args *a) {
  (void)a;
  return MLAW_OK;
}

static inline int sound_step(const mlaw_damage_args *a) {
  (void)a;
  return MLAW_OK;
}

static const mlaw_param PARAM = {.name = "G_s",
                                 .unit = "N/m",
                                 .about = "shear modulus",
                                 .dim = {1, 0, -2},
                                 .value = 1,
                                 .hi = INFINITY,
                                 .ok_hi = INFINITY};
static const mlaw_var VAR = {.name = "s", .unit = "1", .about = "slip"};

/* A plugin with one law of each kind. */
typedef struct {
  mlaw_param param[2];
  mlaw_var var;
  mlaw_energy energy;
  mlaw_damage damage;
  const mlaw_energy *energy_list[1];
  const mlaw_damage *damage_list[1];
  mlaw_plugin plugin;
} Sound;

/* Fills in `sound`, which must stay where it is. */
static inline void sound_make(Sound *sound) {
  *sound = (Sound){.param = {PARAM, PARAM},
                   .var = VAR,
                   .energy = {.size = sizeof(mlaw_energy),
                              .id = "elastic",
                              .title = "t",
                              .source = "s",
                              .params = sound->param,
                              .n_params = 2,
                              .param_size = sizeof(mlaw_param),
                              .eval = sound_eval},
                   .damage = {.size = sizeof(mlaw_damage),
                              .id = "slip",
                              .title = "t",
                              .source = "s",
                              .vars = &sound->var,
                              .n_vars = 1,
                              .var_size = sizeof(mlaw_var),
                              .needs = 1u << MLAW_T1,
                              .update = sound_step},
                   .energy_list = {&sound->energy},
                   .damage_list = {&sound->damage},
                   .plugin = {.size = sizeof(mlaw_plugin),
                              .abi_minor = MLAW_ABI_MINOR,
                              .id = "test",
                              .version = "1",
                              .license = "MIT",
                              .author = "a",
                              .n_energy = 1,
                              .n_damage = 1,
                              .energy = sound->energy_list,
                              .damage = sound->damage_list}};
}

#endif
