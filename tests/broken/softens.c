/* zeta falls again beyond Y = 1.5, and f does not know of it. */
#include "fixture.h"

ONE_PARAMETER("Y_D");
static int evolution(const mlaw_damage_args *a) {
  sound_evolution(a);
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->chan[MLAW_Y][i] > 1.5) a->zeta[i] = 2.0 - a->chan[MLAW_Y][i];
  }
  return MLAW_OK;
}
static const mlaw_damage law = {ALIKE(mlaw_damage, "softens"), .needs = 1u << MLAW_Y,
                                .threshold = sound_threshold, .evolution = evolution};
DAMAGE_PLUGIN("softens")
