/* Declines to serve. */
#include "fixture.h"

ENTRY(NULL)
