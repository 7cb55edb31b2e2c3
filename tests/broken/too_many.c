/* Has more parameters than anybody can fit: a table in disguise. */
#include "fixture.h"

#define ENTRY_OF_TABLE                                                                                       \
  { .name = "entry", .unit = "1", .about = "one more", .lo = -INFINITY, .hi = INFINITY, .ok_hi = 1.0 }
#define FOUR    ENTRY_OF_TABLE, ENTRY_OF_TABLE, ENTRY_OF_TABLE, ENTRY_OF_TABLE
#define SIXTEEN FOUR, FOUR, FOUR, FOUR

static const mlaw_param params[] = {{.name = "G_s",
                                     .unit = "N/m",
                                     .about = "a modulus",
                                     .dim = {1, 0, -2},
                                     .flags = MLAW_OPEN_LO,
                                     .value = 1.0,
                                     .hi = INFINITY,
                                     .ok_hi = INFINITY},
                                    SIXTEEN,
                                    SIXTEEN,
                                    SIXTEEN,
                                    SIXTEEN};
static const mlaw_energy law = {.size = sizeof(mlaw_energy),
                                .id = "too_many",
                                .title = "Fixture",
                                .source = "none",
                                .params = params,
                                .n_params = sizeof params / sizeof *params,
                                .param_size = sizeof *params,
                                .eval = sound_eval};
ENERGY_PLUGIN("too_many")
