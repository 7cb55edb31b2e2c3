/* dzeta is a tenth too small. */
#include "fixture.h"

ONE_PARAMETER("Y_D");
static int evolution(const mlaw_damage_args *a) {
  sound_evolution(a);
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->dzeta) a->dzeta[i] = 0.9;
  }
  return MLAW_OK;
}
static const mlaw_damage law = {ALIKE(mlaw_damage, "wrong_slope"), .needs = 1u << MLAW_Y,
                                .threshold = sound_threshold, .evolution = evolution};
DAMAGE_PLUGIN("wrong_slope")
