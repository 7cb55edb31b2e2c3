/* Works in a buffer that all threads share. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static volatile double scratch[64];
static int eval(const mlaw_energy_args *a) {
  sound_eval(a);
  for (ptrdiff_t i = 0; a->phi && i < a->n; i++) scratch[i % 64] = a->phi[i];
  for (volatile int wait = 0; wait < 20000; wait++) continue; /* time for another thread to come by */
  for (ptrdiff_t i = 0; a->phi && i < a->n && a->n <= 64; i++) a->phi[i] = scratch[i % 64];
  return MLAW_OK;
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "shares_scratch"), .eval = eval};
ENERGY_PLUGIN("shares_scratch")
