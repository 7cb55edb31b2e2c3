/* Follows a null pointer whenever it is called. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  volatile double *volatile nowhere = NULL;
  *nowhere = a->I1[0];
  return MLAW_OK;
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "crashes"), .eval = eval};
ENERGY_PLUGIN("crashes")
