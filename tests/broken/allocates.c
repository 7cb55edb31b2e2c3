/* Takes its scratch from the heap in every call. */
#include "fixture.h"
#include <stdlib.h>
#include <string.h>

ONE_PARAMETER("G_s");
static int eval(const mlaw_energy_args *a) {
  double *volatile scratch = malloc(((size_t)a->n + 1) * sizeof *scratch);
  if (!scratch) return mlaw_fail(a->err, MLAW_INTERNAL, -1, "out of memory");
  memcpy(scratch, a->I1, (size_t)a->n * sizeof *scratch);
  free(scratch);
  return sound_eval(a);
}
static const mlaw_energy law = {ALIKE(mlaw_energy, "allocates"), .eval = eval};
ENERGY_PLUGIN("allocates")
