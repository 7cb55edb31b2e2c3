/* A shared object that is no plugin. */
#include "fixture.h"

MLAW_EXPORT int something_else(void);
int something_else(void) {
  return 0;
}
