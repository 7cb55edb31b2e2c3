/* Ends the process while it is opened. */
#include "fixture.h"
#include <unistd.h>

__attribute__((constructor)) static void start(void) {
  _exit(3);
}
ENTRY(NULL)
