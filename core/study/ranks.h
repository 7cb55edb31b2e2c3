/* The ranks of an MPI job (`mpirun capsella study ...`): rank 0 leads, the others start processes for it.
 *
 * Ranks exchange small messages; results go through the folder of the study, which all of them see.  A
 * program that was built without MPI, or was started without mpirun, is one rank. */
#ifndef CAPSELLA_STUDY_RANKS_H
#define CAPSELLA_STUDY_RANKS_H

#include "base/status.h"
#include "base/text.h"
#include <stdbool.h>

typedef enum {
  MESSAGE_JOB,  /* 0 to r: texts, each with its NUL */
  MESSAGE_STOP, /* 0 to r: stop what is running */
  MESSAGE_QUIT, /* 0 to r: no more jobs */
  MESSAGE_END   /* r to 0: three numbers as text */
} MessageKind;

typedef struct {
  int rank; /* of the sender */
  MessageKind kind;
  Text bytes;
} Message;

/* Joins the job, if there is one.  STATUS_INPUT when mpirun has started several ranks of a program built
 * without MPI: each would run the whole study. */
Status ranks_open(Error *error);
/* Leaves it; rank 0 lets the others go. */
void ranks_close(void);

int ranks_own(void);   /* from 0 */
int ranks_count(void); /* at least 1 */

void ranks_send(int rank, MessageKind kind, const char *bytes, size_t length);

/* Whether a message was there; its bytes are appended to message->bytes. */
Status ranks_receive(Message *message, bool *received, Error *error);

#endif
