/* The only file that includes mpi.h. */
#include "study/ranks.h"

#include <stdlib.h>
#ifdef CAPSELLA_MPI
#include "base/array.h"
#include <limits.h>
#include <mpi.h>
#endif

/* How many processes the starter of this one says it has started. */
static long announced(void) {
  static const char *const names[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    const char *value = getenv(names[i]);
    if (value) return strtol(value, NULL, 10);
  }
  return 1;
}

#ifdef CAPSELLA_MPI

static bool is_open(void) {
  int begun = 0, ended = 0;
  MPI_Initialized(&begun);
  MPI_Finalized(&ended);
  return begun && !ended;
}

Status ranks_open(Error *error) {
  if (announced() < 2) return STATUS_OK;
  if (MPI_Init(NULL, NULL) != MPI_SUCCESS)
    return error_set(error, STATUS_FAILED, "MPI does not start (MPI_Init)");
  return STATUS_OK;
}

void ranks_close(void) {
  if (!is_open()) return;
  for (int rank = 1; ranks_own() == 0 && rank < ranks_count(); rank++) ranks_send(rank, MESSAGE_QUIT, "", 0);
  MPI_Finalize();
}

int ranks_own(void) {
  int rank = 0;
  if (is_open()) MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int ranks_count(void) {
  int count = 1;
  if (is_open()) MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

void ranks_send(int rank, MessageKind kind, const char *bytes, size_t length) {
  if (length <= INT_MAX) MPI_Send(bytes, (int)length, MPI_CHAR, rank, (int)kind, MPI_COMM_WORLD);
}

Status ranks_receive(Message *message, bool *received, Error *error) {
  int waiting = 0, length = 0;
  MPI_Status about;
  *received = false;
  if (!is_open()) return STATUS_OK;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &waiting, &about);
  if (!waiting) return STATUS_OK;
  MPI_Get_count(&about, MPI_CHAR, &length);
  char *bytes = array_allocate((size_t)length + 1, 1, "message", error);
  if (!bytes) return error->code;
  MPI_Recv(bytes, length, MPI_CHAR, about.MPI_SOURCE, about.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  message->rank = about.MPI_SOURCE;
  message->kind = (MessageKind)about.MPI_TAG;
  const Status status = text_append_bytes(&message->bytes, error, bytes, (size_t)length);
  array_free(bytes);
  *received = status == STATUS_OK;
  return status;
}

#else

Status ranks_open(Error *error) {
  if (announced() < 2) return STATUS_OK;
  return error_set(
      error, STATUS_INPUT,
      "mpirun has started %ld processes, but this program was built without MPI; start it once, or "
      "build it where CMake finds MPI",
      announced());
}

void ranks_close(void) {}

int ranks_own(void) {
  return 0;
}

int ranks_count(void) {
  return 1;
}

void ranks_send(int rank, MessageKind kind, const char *bytes, size_t length) {
  (void)rank;
  (void)kind;
  (void)bytes;
  (void)length;
}

Status ranks_receive(Message *message, bool *received, Error *error) {
  (void)message;
  (void)error;
  *received = false;
  return STATUS_OK;
}

#endif
