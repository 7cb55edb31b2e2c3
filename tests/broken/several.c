/* Not a fault: three laws of one vendor in one file. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static const mlaw_energy first = {ALIKE(mlaw_energy, "several.first"), .eval = sound_eval};
static const mlaw_energy second = {ALIKE(mlaw_energy, "several.second"), .eval = sound_eval};
static const mlaw_damage damage = {ALIKE(mlaw_damage, "several.damage"), .needs = 1u << MLAW_Y,
                                   .threshold = sound_threshold, .evolution = sound_evolution};
static const mlaw_energy *const energies[] = {&first, &second};
static const mlaw_damage *const damages[] = {&damage};
static const mlaw_plugin plugin = {PLUGIN_HEAD("several"), .n_energy = 2, .energy = energies, .n_damage = 1,
                                   .damage = damages};
ENTRY(&plugin)
