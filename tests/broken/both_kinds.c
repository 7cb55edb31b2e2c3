/* A damage law that is of the explicit and of the general kind at once. */
#include "fixture.h"

ONE_PARAMETER("Y_D");
static const mlaw_damage law = {ALIKE(mlaw_damage, "both_kinds"), .needs = 1u << MLAW_Y,
                                .threshold = sound_threshold, .evolution = sound_evolution,
                                .update = sound_evolution};
DAMAGE_PLUGIN("both_kinds")
