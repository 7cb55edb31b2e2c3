/* What a folder of results is turned into for its readers: picture, curves and page. */
#ifndef CAPSELLA_RUN_REPORT_H
#define CAPSELLA_RUN_REPORT_H

#include "run/report_picture.h"

/* Writes FOLDER/capsule.svg, FOLDER/curves.svg and the page FOLDER/report.html. `written` receives the paths,
 * one a line. */
Status report_folder(const char *folder, const ReportChoice *choice, Text *written, Error *error);

#endif
