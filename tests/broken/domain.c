/* Not a fault but a limit: refuses I1 > 1, names the point, and stops the run beyond I1 = 10. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->I1[i] > 10.0) return mlaw_fail(a->err, MLAW_INTERNAL, i, "beyond all bounds");
    if (a->I1[i] > 1.0) return mlaw_fail(a->err, MLAW_DOMAIN, i, "I1 is beyond 1");
  }
  return sound_eval(a);
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "domain"), .eval = eval};
ENERGY_PLUGIN("domain")
