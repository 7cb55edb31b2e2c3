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
} Log;

Status log_open(Log *log, const char *path, bool append, bool quiet, Error *error);
void log_close(Log *log);
void log_note(Log *log, const char *format, ...) PRINTF_LIKE(2, 3);
void log_warning(Log *log, const char *format, ...) PRINTF_LIKE(2, 3);

#endif
