/* Lines are few and short: they are searched in order. */
#include "study/journal.h"

#include "base/array.h"
#include "base/file.h"
#include "base/text.h"
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const NAMES[] = {
    [JOURNAL_STARTED] = "started", [JOURNAL_DONE] = "done", [JOURNAL_FAILED] = "failed"};
enum { N_NAMES = sizeof NAMES / sizeof *NAMES };

/* ---- entries in memory ---- */

static JournalEntry *find(const Journal *journal, const char *label) {
  for (size_t i = 0; i < journal->n; i++)
    if (strcmp(journal->entries[i].label, label) == 0) return &journal->entries[i];
  return NULL;
}

const JournalEntry *journal_find(const Journal *journal, const char *label) {
  return find(journal, label);
}

static Status grow(Journal *journal, Error *error) {
  if (journal->n < journal->capacity) return STATUS_OK;
  const size_t capacity = journal->capacity ? 2 * journal->capacity : 64;
  JournalEntry *entries;
  const Status status = ARRAY_NEW(&entries, capacity, error);
  if (status != STATUS_OK) return status;
  if (journal->n) memcpy(entries, journal->entries, journal->n * sizeof *entries);
  array_free(journal->entries);
  journal->entries = entries;
  journal->capacity = capacity;
  return STATUS_OK;
}

static Status keep(Journal *journal, JournalState state, const char *label, uint64_t identity,
                   const char *reason, Error *error) {
  Status status = STATUS_OK;
  char *text = text_copy(reason, error);
  if (!text) return error->code;
  JournalEntry *entry = find(journal, label);
  if (!entry) {
    TRY(grow(journal, error));
    char *name = text_copy(label, error);
    if (!name) TRY(error->code);
    entry = &journal->entries[journal->n++];
    *entry = (JournalEntry){.label = name};
  }
  array_free(entry->reason);
  entry->reason = text;
  entry->state = state;
  entry->identity = identity;
  return STATUS_OK;
cleanup:
  array_free(text);
  return status;
}

static void forget(Journal *journal) {
  for (size_t i = 0; i < journal->n; i++) {
    array_free(journal->entries[i].label);
    array_free(journal->entries[i].reason);
  }
  journal->n = 0;
}

/* ---- lines on disk ---- */

/* Reads a line without its end; false when it is none of ours. */
static bool parse(char *line, JournalState *state, char **label, uint64_t *identity, char **reason) {
  *label = strchr(line, ' ');
  if (!*label) return false;
  *(*label)++ = '\0';
  char *digits = strchr(*label, ' '), *end;
  if (!digits) return false;
  *digits++ = '\0';
  errno = 0;
  *identity = strtoull(digits, &end, 16);
  if (end != digits + 16 || errno != 0 || (*end != '\0' && *end != ' ')) return false;
  *reason = *end ? end + 1 : end;
  for (int i = 0; i < N_NAMES; i++)
    if (strcmp(line, NAMES[i]) == 0) {
      *state = (JournalState)i;
      return true;
    }
  return false;
}

/* Keeps whole lines; cuts off the rest, so that the next line starts on its own. */
static Status read_lines(Journal *journal, const char *path, Error *error) {
  Status status = STATUS_OK;
  Text text = {0};
  char block[4096];
  ssize_t count;
  TRY(text_append(&text, error, "%s", ""));
  while ((count = read(journal->handle, block, sizeof block)) > 0)
    TRY(text_append_bytes(&text, error, block, (size_t)count));
  if (count < 0) TRY(error_set(error, STATUS_IO, "%s: cannot be read: %s", path, strerror(errno)));
  char *line = text.data;
  for (char *end; (end = strchr(line, '\n')); line = end + 1) {
    JournalState state;
    char *label, *reason;
    uint64_t identity;
    *end = '\0';
    if (parse(line, &state, &label, &identity, &reason))
      TRY(keep(journal, state, label, identity, reason, error));
  }
  if (ftruncate(journal->handle, line - text.data) != 0)
    TRY(error_set(error, STATUS_IO, "%s: cannot be cut to its last whole line: %s", path, strerror(errno)));
cleanup:
  text_free(&text);
  return status;
}

Status journal_open(Journal *journal, const char *folder, Error *error) {
  Status status = STATUS_OK;
  Text path = {0};
  struct flock lock = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
  *journal = (Journal){.handle = -1};
  TRY(file_join(&path, folder, "journal.txt", error));
  journal->handle = open(path.data, O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (journal->handle < 0)
    TRY(error_set(error, STATUS_IO, "%s: cannot be opened: %s", path.data, strerror(errno)));
  if (fcntl(journal->handle, F_SETLK, &lock) != 0)
    TRY(error_set(error, STATUS_IO, "%s: another study is at work in this folder (%s)", path.data,
                  strerror(errno)));
  /* Closing any handle of the file would drop the lock: it is read through the open one only. */
  TRY(read_lines(journal, path.data, error));
cleanup:
  text_free(&path);
  if (status != STATUS_OK) journal_close(journal);
  return status;
}

void journal_close(Journal *journal) {
  forget(journal);
  array_free(journal->entries);
  if (journal->handle >= 0) close(journal->handle);
  *journal = (Journal){.handle = -1};
}

static Status write_all(int handle, const char *bytes, size_t length, Error *error) {
  while (length > 0) {
    const ssize_t written = write(handle, bytes, length);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0)
      return error_set(error, STATUS_IO, "the journal cannot be written: %s", strerror(errno));
    bytes += written;
    length -= (size_t)written;
  }
  if (fsync(handle) != 0 && errno != EINVAL)
    return error_set(error, STATUS_IO, "the journal cannot be synced: %s", strerror(errno));
  return STATUS_OK;
}

Status journal_add(Journal *journal, JournalState state, const char *label, uint64_t identity,
                   const char *reason, Error *error) {
  Status status = STATUS_OK;
  Text line = {0};
  if (!reason) reason = "";
  TRY(text_append(&line, error, "%s %s %016" PRIx64 "%s%s", NAMES[state], label, identity, *reason ? " " : "",
                  reason));
  for (char *c = line.data; *c; c++)
    if (*c == '\n') *c = ' ';
  TRY(text_append(&line, error, "\n"));
  TRY(write_all(journal->handle, line.data, line.length, error));
  TRY(keep(journal, state, label, identity, reason, error));
cleanup:
  text_free(&line);
  return status;
}

Status journal_empty(Journal *journal, Error *error) {
  forget(journal);
  if (ftruncate(journal->handle, 0) != 0)
    return error_set(error, STATUS_IO, "the journal cannot be emptied: %s", strerror(errno));
  return STATUS_OK;
}
