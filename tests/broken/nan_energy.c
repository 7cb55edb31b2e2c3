/* Gives NaN in phi_2 beyond I1 = 1. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  sound_eval(a);
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->dphi && a->I1[i] > 1.0) a->dphi[a->ld + i] = NAN;
  }
  return MLAW_OK;
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "nan_energy"), .flags = MLAW_HESSIAN, .eval = eval};
ENERGY_PLUGIN("nan_energy")
