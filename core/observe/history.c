/* The columns stand in one table; header, rows and the check of a resumed file come from it. */
#include "observe/history.h"

#include "base/text.h"
#include "observe/number.h"
#include <errno.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

typedef struct {
  const char *name;
  size_t offset; /* in HistoryRow */
  bool is_count; /* a long long; otherwise a double */
} Column;

#define NUMBER(member)                                                                                       \
  { #member, offsetof(HistoryRow, member), false }
#define WHOLE(member)                                                                                        \
  { #member, offsetof(HistoryRow, member), true }

static const Column columns[] = {
    NUMBER(t),
    NUMBER(D12),
    NUMBER(beta),
    NUMBER(L1),
    NUMBER(L2),
    NUMBER(L3),
    NUMBER(area_strain),
    NUMBER(volume_error),
    NUMBER(d_max),
    NUMBER(Y_max),
    NUMBER(T1_max),
    NUMBER(T2_min),
    NUMBER(compressed_area),
    NUMBER(wrinkle_amplitude),
    NUMBER(elastic_energy),
    NUMBER(dissipated_energy),
    NUMBER(energy_error),
    NUMBER(step),
    WHOLE(evaluations),
    /* HISTORY_INFLATION only: */
    NUMBER(p),
    NUMBER(d),
    NUMBER(alpha),
};

size_t history_columns(HistoryKind kind) {
  enum { INFLATION_COLUMNS = 3 };
  size_t all = sizeof columns / sizeof *columns;
  return kind == HISTORY_INFLATION ? all : all - INFLATION_COLUMNS;
}

bool history_has_column(const char *name) {
  for (size_t k = 0; k < sizeof columns / sizeof *columns; k++)
    if (strcmp(columns[k].name, name) == 0) return true;
  return false;
}

const char *history_column(size_t k) {
  return columns[k].name;
}

static long long whole_value(const HistoryRow *row, size_t k) {
  long long value;
  memcpy(&value, (const char *)row + columns[k].offset, sizeof value);
  return value;
}

double history_value(const HistoryRow *row, size_t k) {
  double value;
  if (columns[k].is_count) return (double)whole_value(row, k);
  memcpy(&value, (const char *)row + columns[k].offset, sizeof value);
  return value;
}

static const char *separator(HistoryKind kind, size_t column) {
  return column + 1 < history_columns(kind) ? "," : "\n";
}

static Status print_header(HistoryKind kind, Text *line, Error *error) {
  Status status = STATUS_OK;
  for (size_t k = 0; k < history_columns(kind) && status == STATUS_OK; k++)
    status = text_append(line, error, "%s%s", columns[k].name, separator(kind, k));
  return status;
}

static Status print_row(HistoryKind kind, const HistoryRow *row, Text *line, Error *error) {
  Status status = STATUS_OK;
  for (size_t k = 0; k < history_columns(kind) && status == STATUS_OK; k++) {
    char digits[NUMBER_SIZE];
    if (columns[k].is_count)
      snprintf(digits, sizeof digits, "%lld", whole_value(row, k));
    else
      number_print(history_value(row, k), digits);
    status = text_append(line, error, "%s%s", digits, separator(kind, k));
  }
  return status;
}

/* The line reaches the system in one piece, or `bytes` stays where the last whole row ended. */
static Status write_line(History *history, const Text *line, Error *error) {
  size_t written = fwrite(line->data, 1, line->length, history->file);
  if (written != line->length || fflush(history->file) != 0)
    return error_set(error, STATUS_IO, "a row of the history cannot be written: %s", strerror(errno));
  history->bytes += (long long)line->length;
  return STATUS_OK;
}

static void abandon(History *history) {
  if (history->file) fclose(history->file);
  history->file = NULL;
}

Status history_open(History *history, const char *path, HistoryKind kind, Error *error) {
  Status status;
  Text header = {0};
  *history = (History){.kind = kind, .file = fopen(path, "wb")};
  if (!history->file) TRY(error_set(error, STATUS_IO, "%s: cannot be written: %s", path, strerror(errno)));
  TRY(print_header(kind, &header, error));
  TRY(write_line(history, &header, error));
cleanup:
  if (status != STATUS_OK) abandon(history);
  text_free(&header);
  return status;
}

/* A read that ends early leaves bytes that match no header and no line end. */
static int byte_at(FILE *file, long long offset) {
  return fseeko(file, (off_t)offset, SEEK_SET) == 0 ? fgetc(file) : EOF;
}

static bool starts_with(FILE *file, const Text *header) {
  rewind(file);
  for (size_t k = 0; k < header->length; k++)
    if (fgetc(file) != (unsigned char)header->data[k]) return false;
  return true;
}

static Status check_resumable(FILE *file, const char *path, const Text *header, long long bytes,
                              Error *error) {
  static const char advice[] = "start the run again without --resume, or in another folder";
  if (!starts_with(file, header))
    return error_set(error, STATUS_IO,
                     "%s: expected the columns of this scene in the first line, found others; %s", path,
                     advice);
  if (bytes < (long long)header->length || byte_at(file, bytes - 1) != '\n')
    return error_set(error, STATUS_IO,
                     "%s: expected a row that ends at byte %lld, where the snapshot was taken, found none: "
                     "the file was cut or edited; %s",
                     path, bytes, advice);
  return STATUS_OK;
}

Status history_resume(History *history, const char *path, HistoryKind kind, long long bytes, Error *error) {
  Status status;
  Text header = {0};
  *history = (History){.kind = kind, .bytes = bytes, .file = fopen(path, "r+b")};
  if (!history->file)
    TRY(error_set(error, STATUS_IO, "%s: cannot be opened to go on with: %s", path, strerror(errno)));
  TRY(print_header(kind, &header, error));
  TRY(check_resumable(history->file, path, &header, bytes, error));
  if (ftruncate(fileno(history->file), (off_t)bytes) != 0 || fseeko(history->file, 0, SEEK_END) != 0)
    TRY(error_set(error, STATUS_IO, "%s: cannot be cut to %lld bytes: %s", path, bytes, strerror(errno)));
cleanup:
  if (status != STATUS_OK) abandon(history);
  text_free(&header);
  return status;
}

Status history_append(History *history, const HistoryRow *row, Error *error) {
  Text line = {0};
  Status status = print_row(history->kind, row, &line, error);
  if (status == STATUS_OK) status = write_line(history, &line, error);
  text_free(&line);
  return status;
}

Status history_sync(History *history, Error *error) {
  if (fsync(fileno(history->file)) == 0) return STATUS_OK;
  return error_set(error, STATUS_IO, "the history cannot be synced to disk: %s", strerror(errno));
}

Status history_close(History *history, Error *error) {
  if (!history->file) return STATUS_OK;
  Status status = history_sync(history, error);
  abandon(history);
  return status;
}
