/* Tells which law has crashed or hangs: it is code of somebody else's, run in this process. */
#ifndef CAPSELLA_APP_GUARD_H
#define CAPSELLA_APP_GUARD_H

#include "laws/watch.h"

/* From now on a crash or a call longer than `seconds` (0: any length is fine) inside a law ends the process
 * with exit code 1 and a message that names law, time and element.  Returns the slots for the run to fill in.
 */
LawWatch *guard_laws(unsigned seconds);

#endif
