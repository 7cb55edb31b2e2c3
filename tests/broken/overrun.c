/* Rounds the batch up to a multiple of four and writes there. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  mlaw_energy_args longer = *a;
  longer.n = (a->n + 3) / 4 * 4;
  return sound_eval(a->n % 4 == 1 && a->ld >= longer.n ? &longer : a);
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "overrun"), .eval = eval};
ENERGY_PLUGIN("overrun")
