/* Answers every other call of its entry with another table. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static const mlaw_energy law = {ALIKE(mlaw_energy, "alternates"), .eval = sound_eval};
static const mlaw_energy *const laws[] = {&law};
static const mlaw_plugin plugin[] = {{PLUGIN_HEAD("alternates"), .n_energy = 1, .energy = laws},
                                     {PLUGIN_HEAD("alternates"), .n_energy = 1, .energy = laws}};
static int calls;
ENTRY(&plugin[calls++ % 2])
