/* Describes itself with fewer bytes than ABI 1.0 has. */
#include "fixture.h"

static const mlaw_plugin plugin = {.size = offsetof(mlaw_plugin, author)};
ENTRY(&plugin)
