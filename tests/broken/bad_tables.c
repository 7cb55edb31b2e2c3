/* A default outside its range, exponents that belong to another unit, an id in capitals. */
#include "fixture.h"

static const mlaw_param params[] = {{.name = "G_s",
                                     .unit = "N/m",
                                     .about = "a modulus",
                                     .dim = {1, -1, -2},
                                     .value = -1.0,
                                     .lo = 0.0,
                                     .hi = INFINITY,
                                     .ok_lo = -5.0,
                                     .ok_hi = INFINITY}};
static const mlaw_energy law = {ALIKE(mlaw_energy, "Bad Tables"), .eval = sound_eval};
ENERGY_PLUGIN("bad_tables")
