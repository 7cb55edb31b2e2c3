/* Refuses a point without saying which. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->I1[i] > 5.0) return MLAW_DOMAIN;
  }
  return sound_eval(a);
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "nameless_refusal"), .eval = eval};
ENERGY_PLUGIN("nameless_refusal")
