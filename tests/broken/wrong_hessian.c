/* phi_22 is wrong away from rest. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  sound_eval(a);
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->d2phi) a->d2phi[2 * a->ld + i] *= 1.0 + 1e-3 * a->I2[i];
  }
  return MLAW_OK;
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "wrong_hessian"), .flags = MLAW_HESSIAN, .eval = eval};
ENERGY_PLUGIN("wrong_hessian")
