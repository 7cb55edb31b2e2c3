/* Calls a function that nobody defines. */
#include "fixture.h"

int missing_from_every_library(void);
ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  return missing_from_every_library() + sound_eval(a);
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "undefined"), .eval = eval};
ENERGY_PLUGIN("undefined")
