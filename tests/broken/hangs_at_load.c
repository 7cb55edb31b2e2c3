/* Waits for ever while it is opened. */
#include "fixture.h"
#include <unistd.h>

__attribute__((constructor)) static void start(void) {
  pause();
}
ENTRY(NULL)
