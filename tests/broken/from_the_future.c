/* Not a fault: built with a later minor, every structure longer than ours, content to run on ABI 1.0. */
#include "fixture.h"

typedef struct {
  mlaw_param now;
  double later;
} LongerParam;
typedef struct {
  mlaw_energy now;
  int (*later)(void);
} LongerEnergy;
typedef struct {
  mlaw_damage now;
  double later[3];
} LongerDamage;
typedef struct {
  mlaw_plugin now;
  const char *later;
} LongerPlugin;

static const LongerParam params[] = {
    {{.name = "G_s",
      .unit = "N/m",
      .about = "a modulus",
      .dim = {1, 0, -2},
      .flags = MLAW_OPEN_LO,
      .value = 1.0,
      .hi = INFINITY,
      .ok_hi = INFINITY},
     1.0},
    {{.name = "spare", .unit = "1", .about = "does nothing", .value = 7.0, .hi = 10.0, .ok_hi = 10.0}, 2.0}};

static const LongerEnergy law = {{.size = sizeof(LongerEnergy),
                                  .id = "from_the_future",
                                  .title = "Fixture",
                                  .source = "none",
                                  .params = &params[0].now,
                                  .n_params = 2,
                                  .param_size = sizeof(LongerParam),
                                  .eval = sound_eval},
                                 NULL};
static const LongerDamage damage = {{.size = sizeof(LongerDamage),
                                     .id = "from_the_future.damage",
                                     .title = "Fixture",
                                     .source = "none",
                                     .params = &params[0].now,
                                     .n_params = 2,
                                     .param_size = sizeof(LongerParam),
                                     .needs = 1u << MLAW_Y,
                                     .threshold = sound_threshold,
                                     .evolution = sound_evolution},
                                    {1.0, 2.0, 3.0}};
static const mlaw_energy *const laws[] = {&law.now};
static const mlaw_damage *const damage_laws[] = {&damage.now};
static const LongerPlugin plugin = {{.size = sizeof(LongerPlugin),
                                     .abi_minor = 3,
                                     .host_minor_min = 0,
                                     .id = "from_the_future",
                                     .version = "1",
                                     .license = "MIT",
                                     .author = "nobody",
                                     .n_energy = 1,
                                     .n_damage = 1,
                                     .energy = laws,
                                     .damage = damage_laws},
                                    "later"};
ENTRY(&plugin.now)
