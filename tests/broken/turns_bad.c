/* Laws that are sound at first and, where the strain goes beyond I1 = 0.1, crash or never come back. */
#include "fixture.h"

ONE_PARAMETER("G_s");
static int is_strained(const mlaw_energy_args *a) {
  for (ptrdiff_t i = 0; i < a->n; i++) {
    if (a->I1[i] > 0.1) return 1;
  }
  return 0;
}
static int crash(const mlaw_energy_args *a) {
  volatile double *volatile nowhere = NULL;
  if (is_strained(a)) *nowhere = a->I1[0];
  return sound_eval(a);
}
static int hang(const mlaw_energy_args *a) {
  for (volatile int bad = is_strained(a); bad;) continue;
  return sound_eval(a);
}
static const mlaw_energy crashing = {ALIKE(mlaw_energy, "turns_bad.crashing"), .eval = crash};
static const mlaw_energy hanging = {ALIKE(mlaw_energy, "turns_bad.hanging"), .eval = hang};
static const mlaw_energy *const laws[] = {&crashing, &hanging};
static const mlaw_plugin plugin = {PLUGIN_HEAD("turns_bad"), .n_energy = 2, .energy = laws};
ENTRY(&plugin)
