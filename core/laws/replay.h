/* Evaluates a law again on the points of a failed run, and says what is wrong with its answer. */
#ifndef CAPSELLA_LAWS_REPLAY_H
#define CAPSELLA_LAWS_REPLAY_H

#include "base/status.h"
#include "base/text.h"
#include <stdbool.h>

/* Reads the file of a failure (laws/failure.h), opens its plugin, and appends to `report`, line by line: the
 * law and what the run had to say; for the batch as a whole and for each point alone, what the law refuses,
 * does not write, returns that is not finite, or heals; and where batch and point differ.  `is_bad`: there is
 * something of the kind.  In this process, so that a debugger sees it; a law that crashes takes it along. */
Status law_replay(const char *file, Text *report, bool *is_bad, Error *error);

#endif
