/* Clips its input in place. */
#include "fixture.h"

ONE_PARAMETER("Y_D");
static int evolution(const mlaw_damage_args *a) {
  double *Y = (double *)(uintptr_t)a->chan[MLAW_Y];
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (Y[i] < 1.0) Y[i] = 1.0;
  }
  return sound_evolution(a);
}
static const mlaw_damage law = {ALIKE(mlaw_damage, "spoils_input"), .needs = 1u << MLAW_Y,
                                .threshold = sound_threshold, .evolution = evolution};
DAMAGE_PLUGIN("spoils_input")
