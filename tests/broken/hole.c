/* Leaves out the last point of a batch. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  mlaw_energy_args shorter = *a;
  if (a->n > 1) shorter.n--;
  return sound_eval(&shorter);
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "hole"), .eval = eval};
ENERGY_PLUGIN("hole")
