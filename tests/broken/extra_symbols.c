/* Lets everybody see one of its inner functions. */
#include "fixture.h"

MLAW_EXPORT double inner_function(double x);
double inner_function(double x) {
  return 2.0 * x;
}
ONE_PARAMETER("G_s");
static const mlaw_energy law = {ALIKE(mlaw_energy, "extra_symbols"), .eval = sound_eval};
ENERGY_PLUGIN("extra_symbols")
