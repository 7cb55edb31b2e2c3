/* Laws built with the header as ABI 1.0 had it (tests/abi/1.0, which never changes). */
#include "fixture.h"

_Static_assert(MLAW_ABI_MINOR == 0, "this must be the old header");

ONE_PARAMETER("G_s");
static const mlaw_energy elastic = {ALIKE(mlaw_energy, "older_sheet"), .flags = MLAW_HESSIAN,
                                    .eval = sound_eval};
static const mlaw_damage brittle = {ALIKE(mlaw_damage, "older_damage"), .needs = 1u << MLAW_Y,
                                    .threshold = sound_threshold, .evolution = sound_evolution};
static const mlaw_energy *const energy[] = {&elastic};
static const mlaw_damage *const damage[] = {&brittle};
static const mlaw_plugin plugin = {PLUGIN_HEAD("older"), .n_energy = 1, .n_damage = 1, .energy = energy,
                                   .damage = damage};
ENTRY(&plugin)
