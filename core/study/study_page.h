/* The page of a study: report.html from what the study has left in its folder. */
#ifndef CAPSELLA_STUDY_STUDY_PAGE_H
#define CAPSELLA_STUDY_STUDY_PAGE_H

#include "base/status.h"
#include <stdbool.h>

/* Whether a folder holds the results of a study rather than of a run. */
bool study_page_is_study(const char *folder);

/* Writes FOLDER/report.html from summary.json, table.csv, scene.yaml and the last states of the cases, as
 * many of them as keep the page small. */
Status study_page_write(const char *folder, Error *error);

#endif
