/* Sets the rounding direction while it is opened, for the whole process. */
#include "fixture.h"
#include <fenv.h>

__attribute__((constructor)) static void start(void) {
  fesetround(FE_UPWARD);
}

ONE_PARAMETER("G_s");
static const mlaw_energy law = {ALIKE(mlaw_energy, "rounds"), .eval = sound_eval};
ENERGY_PLUGIN("rounds")
