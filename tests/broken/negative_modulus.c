/* A calibrated range in which the membrane is unstable. */
#include "fixture.h"

static const mlaw_param params[] = {{.name = "G_s",
                                     .unit = "N/m",
                                     .about = "a modulus",
                                     .dim = {1, 0, -2},
                                     .value = 1.0,
                                     .lo = -2.0,
                                     .hi = 2.0,
                                     .ok_lo = -2.0,
                                     .ok_hi = 2.0}};
static const mlaw_energy law = {ALIKE(mlaw_energy, "negative_modulus"), .eval = sound_eval};
ENERGY_PLUGIN("negative_modulus")
