/* What a study has started and finished, one line each, on disk before anything else is done.
 *
 * A line is `started|done|failed LABEL IDENTITY [REASON]`; the last one about a label counts, and a line cut
 * off by a crash is dropped.  The identity is a hash of all that decides a case's numbers, so that a case is
 * taken over only when it would be computed the same again.  The open journal is locked: one study at a time
 * works in a folder. */
#ifndef CAPSELLA_STUDY_JOURNAL_H
#define CAPSELLA_STUDY_JOURNAL_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum { JOURNAL_STARTED, JOURNAL_DONE, JOURNAL_FAILED } JournalState;

typedef struct {
  char *label;
  uint64_t identity;
  JournalState state;
  char *reason; /* of a failure, on one line; "" otherwise */
} JournalEntry;

typedef struct {
  int handle; /* -1: closed */
  JournalEntry *entries;
  size_t n, capacity;
} Journal;

/* Opens FOLDER/journal.txt and reads it.  STATUS_IO when another process has it open. */
Status journal_open(Journal *journal, const char *folder, Error *error);
void journal_close(Journal *journal);

/* The last entry about a label, or NULL. */
const JournalEntry *journal_find(const Journal *journal, const char *label);

/* Adds a line and waits until it is on disk; `reason` may be NULL. */
Status journal_add(Journal *journal, JournalState state, const char *label, uint64_t identity,
                   const char *reason, Error *error);

/* Forgets everything. */
Status journal_empty(Journal *journal, Error *error);

#endif
