/* The general kind, with damage that grows with the number of calls and not with time. */
#include "fixture.h"

ONE_PARAMETER("Y_D");
static int update(const mlaw_damage_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) a->d1[i] = a->d0[i] + (a->chan[MLAW_Y][i] > 0.1 ? 1e-3 : 0.0);
  return MLAW_OK;
}
static const mlaw_damage law = {ALIKE(mlaw_damage, "per_call"), .needs = 1u << MLAW_Y, .update = update};
DAMAGE_PLUGIN("per_call")
