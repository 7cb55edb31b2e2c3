/* Work that calls a stranger's plugin, in a process of its own: a crash, or a law that does not come back,
 * costs the answer and not the command. */
#ifndef CAPSELLA_APP_CHILD_H
#define CAPSELLA_APP_CHILD_H

#include "base/status.h"
#include "base/text.h"
#include <stdio.h>

/* Returns the exit code of the process. */
typedef int ChildWork(void *context, FILE *answer);

/* Runs `work` in a child, which is ended after `seconds`.  `answer` receives what the work has written to its
 * file, while whatever the child prints is dropped; where `answer` is NULL, the work prints as we do.
 * STATUS_OK: the child has ended by itself, with `code`.  STATUS_FAILED: it has not, and the message is how
 * it ended.  A signal from the user ends us as it has ended the child. */
Status child_run(ChildWork *work, void *context, unsigned seconds, Text *answer, int *code, Error *error);

#endif
