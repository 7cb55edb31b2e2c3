/* The page of a run: report.html from what the run has left in its folder. */
#ifndef CAPSELLA_RUN_RUN_PAGE_H
#define CAPSELLA_RUN_RUN_PAGE_H

#include "base/log.h"
#include "base/status.h"

/* Writes FOLDER/report.html from resolved.yaml, history.csv, criteria.csv (if any), summary.json (left out
 * when it is missing: the run goes on) and the snapshots.  A damaged snapshot is left out with a warning in
 * the log (may be NULL), and so are some snapshots and rows where the page would become too large. */
Status run_page_write(const char *folder, Log *log, Error *error);

#endif
