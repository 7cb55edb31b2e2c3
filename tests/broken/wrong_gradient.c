/* phi_1 is wrong by one part in ten thousand away from rest. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  sound_eval(a);
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->dphi) a->dphi[i] += 1e-4 * a->I1[i]; /* right at rest */
  }
  return MLAW_OK;
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "wrong_gradient"), .eval = eval};
ENERGY_PLUGIN("wrong_gradient")
