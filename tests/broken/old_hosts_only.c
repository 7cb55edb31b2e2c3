/* Declines hosts that are newer than itself. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static const mlaw_energy law = {ALIKE(mlaw_energy, "old_hosts_only"), .eval = sound_eval};
static const mlaw_energy *const laws[] = {&law};
static const mlaw_plugin plugin = {PLUGIN_HEAD("old_hosts_only"), .n_energy = 1, .energy = laws};
const mlaw_plugin *mlaw_plugin_v1(uint32_t host_minor) {
  return host_minor > MLAW_ABI_MINOR ? NULL : &plugin;
}
