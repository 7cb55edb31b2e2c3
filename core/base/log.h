/* The log of a run: a file in the result folder and, unless quiet, standard error for warnings.  A NULL log
 * is allowed everywhere and swallows the line. */
#ifndef CAPSELLA_BASE_LOG_H
#define CAPSELLA_BASE_LOG_H

#include "base/status.h"
#include <stdbool.h>
#include <stdio.h>

typedef struct {
  FILE *file; /* NULL: none */
  bool quiet; /* warnings go to the file only */
  long warnings;
  long earlier; /* bytes before the first line of this log */
} Log;

/* Lines go behind those that are there.  STATUS_IO also where another process has the same log open: two runs
 * in one folder would spoil each other's results. */
Status log_open(Log *log, const char *path, bool quiet, Error *error);
/* Drops the lines that were there before the log was opened: those of an earlier run. */
void log_drop_earlier(Log *log);
void log_close(Log *log);
void log_note(Log *log, const char *format, ...) PRINTF_LIKE(2, 3);
void log_warning(Log *log, const char *format, ...) PRINTF_LIKE(2, 3);

#endif
