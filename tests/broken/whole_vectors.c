/* Takes no fewer points at a time than its vectors hold. */
#include "fixture.h"

ONE_PARAMETER("Y_D");
static int threshold(const mlaw_damage_args *a) {
  if (a->n < 8) return mlaw_fail(a->err, MLAW_BADARG, -1, "fewer than 8 points");
  return sound_threshold(a);
}
static const mlaw_damage law = {ALIKE(mlaw_damage, "whole_vectors"), .needs = 1u << MLAW_Y,
                                .threshold = threshold, .evolution = sound_evolution};
DAMAGE_PLUGIN("whole_vectors")
