/* Needs a host newer than any of this major. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static const mlaw_energy law = {ALIKE(mlaw_energy, "newer_minor"), .eval = sound_eval};
static const mlaw_energy *const laws[] = {&law};
static const mlaw_plugin plugin = {PLUGIN_HEAD("newer_minor"), .host_minor_min = 700, .n_energy = 1,
                                   .energy = laws};
ENTRY(&plugin)
