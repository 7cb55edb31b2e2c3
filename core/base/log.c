/* The log of a run.  A line is on disk as soon as the call returns, so that the log tells of a crash. */
#include "base/log.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <string.h>
#include <unistd.h>

/* Whether the file is ours alone.  The lock goes with the process, however it ends; a file system without
 * locks takes every claim. */
static Status claim(FILE *file, const char *path, Error *error) {
  struct flock lock = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
  if (fcntl(fileno(file), F_SETLK, &lock) == 0 || (errno != EACCES && errno != EAGAIN)) return STATUS_OK;
  return error_set(error, STATUS_IO, "%s: another run is writing into this folder; give this one its own",
                   path);
}

Status log_open(Log *log, const char *path, bool quiet, Error *error) {
  *log = (Log){.quiet = quiet, .file = fopen(path, "a+")};
  if (!log->file)
    return error_set(error, STATUS_IO, "%s: the log cannot be written: %s", path, strerror(errno));
  const Status status = claim(log->file, path, error);
  if (status != STATUS_OK) {
    log_close(log);
    return status;
  }
  fseek(log->file, 0, SEEK_END);
  log->earlier = ftell(log->file);
  return STATUS_OK;
}

/* The lines of this log are few so far: they are read, and written again at the start. */
void log_drop_earlier(Log *log) {
  char lines[8192];
  if (!log || !log->file || log->earlier <= 0 || fseek(log->file, log->earlier, SEEK_SET) != 0) return;
  const size_t length = fread(lines, 1, sizeof lines, log->file);
  if (length == sizeof lines || ferror(log->file) || ftruncate(fileno(log->file), 0) != 0) return;
  fseek(log->file, 0, SEEK_END);
  fwrite(lines, 1, length, log->file);
  fflush(log->file);
  log->earlier = 0;
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
