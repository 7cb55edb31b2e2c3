/* Has a tension at rest. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  sound_eval(a);
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->dphi) a->dphi[a->ld + i] += 0.01;
  }
  return MLAW_OK;
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "prestressed"), .eval = eval};
ENERGY_PLUGIN("prestressed")
