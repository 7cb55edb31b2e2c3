/* Remembers the largest I1 it has ever seen. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static double largest;
static int eval(const mlaw_energy_args *a) {
  sound_eval(a);
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->I1[i] > largest) largest = a->I1[i];
    if (a->phi) a->phi[i] += 0.01 * largest;
  }
  return MLAW_OK;
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "keeps_state"), .eval = eval};
ENERGY_PLUGIN("keeps_state")
