/* Never comes back from a batch whose I1 is not 0 throughout. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  for (volatile ptrdiff_t i = 0; i < a->n;) {
    if (a->I1[i] == 0.0) i = i + 1;
  }
  return sound_eval(a);
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "endless"), .eval = eval};
ENERGY_PLUGIN("endless")
