/* Follows a null pointer while it is opened. */
#include "fixture.h"

__attribute__((constructor)) static void start(void) {
  volatile double *volatile nowhere = NULL;
  *nowhere = 1.0;
}
ENTRY(NULL)
