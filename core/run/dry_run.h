/* A run that writes nothing: is everything there and right, and what will it cost? */
#ifndef CAPSELLA_RUN_DRY_RUN_H
#define CAPSELLA_RUN_DRY_RUN_H

#include "run/run.h"

/* Everything that run_scene would refuse, it refuses: scene, laws, folder, an unstable fixed step, a snapshot
 * to resume from.  Then it takes the first steps, for a second or so, and appends a table of what the run
 * will be to `report`.  Neither folder nor files are made or changed. */
Status run_dry(const RunOptions *options, Text *report, Error *error);

#endif
