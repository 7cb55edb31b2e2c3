/* Pictures from a folder of results. */
#ifndef CAPSELLA_RUN_REPORT_H
#define CAPSELLA_RUN_REPORT_H

#include "base/status.h"
#include "base/text.h"

/* Draws the state of the newest snapshot into FOLDER/capsule.svg: coloured by d, or by Y without a damage
 * law; and writes the page FOLDER/report.html. `written` receives the paths, one a line. */
Status report_folder(const char *folder, Text *written, Error *error);

#endif
