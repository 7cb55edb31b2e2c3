/* The general kind, with damage that falls. */
#include "fixture.h"

ONE_PARAMETER("rate");
static int update(const mlaw_damage_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) a->d1[i] = a->d0[i] - 0.1;
  return MLAW_OK;
}
static const mlaw_damage law = {ALIKE(mlaw_damage, "healing"), .needs = 1u << MLAW_Y, .update = update};
DAMAGE_PLUGIN("healing")
