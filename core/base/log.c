/* The log of a run.  A line is on disk as soon as the call returns, so that the log tells of a crash. */
#include "base/log.h"

#include <errno.h>
#include <stdarg.h>
#include <string.h>

Status log_open(Log *log, const char *path, bool append, bool quiet, Error *error) {
  *log = (Log){.quiet = quiet, .file = fopen(path, append ? "a" : "w")};
  if (!log->file)
    return error_set(error, STATUS_IO, "%s: the log cannot be written: %s", path, strerror(errno));
  return STATUS_OK;
}

void log_close(Log *log) {
  if (!log) return;
  if (log->file) fclose(log->file);
  log->file = NULL;
}

PRINTF_LIKE(3, 0)
static void write_line(FILE *file, const char *mark, const char *format, va_list arguments) {
  fputs(mark, file);
  vfprintf(file, format, arguments);
  fputc('\n', file);
  fflush(file);
}

void log_note(Log *log, const char *format, ...) {
  if (!log || !log->file) return;
  va_list arguments;
  va_start(arguments, format);
  write_line(log->file, "", format, arguments);
  va_end(arguments);
}

void log_warning(Log *log, const char *format, ...) {
  if (!log) return;
  log->warnings++;
  FILE *targets[2] = {log->file, log->quiet ? NULL : stderr};
  for (int k = 0; k < 2; k++) {
    if (!targets[k]) continue;
    va_list arguments;
    va_start(arguments, format);
    write_line(targets[k], "warning: ", format, arguments);
    va_end(arguments);
  }
}
