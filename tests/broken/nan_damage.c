/* Gives NaN in zeta at every point. */
#include "fixture.h"

ONE_PARAMETER("Y_D");
static int evolution(const mlaw_damage_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) a->zeta[i] = NAN;
  return MLAW_OK;
}
static const mlaw_damage law = {ALIKE(mlaw_damage, "nan_damage"), .needs = 1u << MLAW_Y,
                                .threshold = sound_threshold, .evolution = evolution};
DAMAGE_PLUGIN("nan_damage")
