/* Does at start what objects linked with -ffast-math do: subnormal numbers become 0 in the whole process. */
#include "fixture.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
__attribute__((constructor)) static void start(void) {
  _mm_setcsr(_mm_getcsr() | 0x8040u); /* flush to zero, denormals are zero */
}
#endif

ONE_PARAMETER("G_s");
static const mlaw_energy law = {ALIKE(mlaw_energy, "flushes_subnormals"), .eval = sound_eval};
ENERGY_PLUGIN("flushes_subnormals")
