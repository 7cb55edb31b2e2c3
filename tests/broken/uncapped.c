/* Not a fault: damage grows without end in the law's own history, and the host caps what it is told. */
#include "fixture.h"

ONE_PARAMETER("Y_D");
static const mlaw_var vars[] = {{.name = "d", .unit = "1", .about = "damage that is not capped"}};
static int update(const mlaw_damage_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) {
    const double last = a->state0[i] > a->d0[i] ? a->state0[i] : a->d0[i], Y = a->chan[MLAW_Y][i];
    a->d1[i] = a->state1[i] = last < Y ? Y : last;
  }
  return MLAW_OK;
}
static const mlaw_damage law = {ALIKE(mlaw_damage, "uncapped"), .vars = vars,          .n_vars = 1,
                                .var_size = sizeof(mlaw_var),   .needs = 1u << MLAW_Y, .update = update};
DAMAGE_PLUGIN("uncapped")
