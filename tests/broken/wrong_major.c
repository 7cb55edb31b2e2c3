/* Speaks ABI 2 only. */
#include "fixture.h"

MLAW_EXPORT const mlaw_plugin *mlaw_plugin_v2(uint32_t host_minor);
const mlaw_plugin *mlaw_plugin_v2(uint32_t host_minor) {
  (void)host_minor;
  return NULL;
}
