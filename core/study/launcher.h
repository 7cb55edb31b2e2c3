/* Processes side by side: each a copy of this program with arguments of its own, in one of a number of slots.
 */
#ifndef CAPSELLA_STUDY_LAUNCHER_H
#define CAPSELLA_STUDY_LAUNCHER_H

#include "base/status.h"

/* A process to start.  It waits first until no other one holds its lock. */
typedef struct {
  char *const *arguments;  /* with the name of the program; ends in NULL */
  const char *lock;        /* a file of the case, locked while the process lives */
  const char *messages;    /* the file that receives what it says as errors */
  const char *plugin_path; /* its MLAW_PLUGIN_PATH */
} Job;

/* How a process ended. */
typedef struct {
  int slot;   /* -1: none has ended */
  int code;   /* exit code, -1 when it was ended by a signal */
  int signal; /* 0: none */
} JobEnd;

typedef struct Launcher Launcher;

/* `slots` on each rank; `program` is what is run, NULL: the program that calls. */
Status launcher_new(Launcher **launcher, int slots, const char *program, Error *error);
/* Ends what is still running. */
void launcher_free(Launcher *launcher);

int launcher_slots(const Launcher *launcher); /* of all ranks */

/* Starts a job in a slot that is free. */
Status launcher_start(Launcher *launcher, int slot, const Job *job, Error *error);

/* A process that has ended, if any has by now; waits a few milliseconds at most. */
Status launcher_poll(Launcher *launcher, JobEnd *end, Error *error);

/* Returns when no process holds the lock of a job any more. */
void launcher_await_lock(const char *path);

/* Asks all processes to stop after their current step. */
void launcher_stop(Launcher *launcher);

/* On a rank other than 0: starts what rank 0 asks for, until that lets it go.  `interrupt` as in a run. */
Status launcher_serve(Launcher *launcher, const volatile int *interrupt, Error *error);

#endif
