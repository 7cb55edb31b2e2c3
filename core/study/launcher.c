/* fork and exec.  A process whose parent dies, however that happens, is asked to stop where the system can do
 * that; and where two meet in one folder all the same, a lock makes the later one wait. */
#include "study/launcher.h"

#include "base/array.h"
#include "base/text.h"
#include "study/ranks.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

enum { CANNOT_START = 127 };

struct Launcher {
  int slots; /* of this rank, numbers 0 to slots - 1; those of the next rank follow */
  const char *program;
  pid_t *process; /* [slots]; 0: free */
};

Status launcher_new(Launcher **launcher, int slots, const char *program, Error *error) {
  Status status = STATUS_OK;
  TRY(ARRAY_NEW(launcher, 1, error));
  (*launcher)->slots = slots;
  (*launcher)->program = program ? program : "/proc/self/exe";
  TRY(ARRAY_NEW(&(*launcher)->process, slots, error));
cleanup:
  if (status != STATUS_OK) launcher_free(*launcher);
  return status;
}

int launcher_slots(const Launcher *launcher) {
  return launcher->slots * ranks_count();
}

static void stop_with_parent(pid_t parent) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
  if (getppid() != parent) _exit(CANNOT_START); /* it died before that took hold */
}

static bool redirect(int stream, const char *path, int flags) {
  const int file = open(path, flags, 0666);
  if (file < 0) return false;
  const bool done = dup2(file, stream) == stream;
  if (file != stream) close(file);
  return done;
}

/* The lock belongs to the process and outlives exec, as long as the file stays open: its handle, -1 when the
 * file cannot be opened.  A file system without locks does not stop anything. */
static int take_lock(const char *path) {
  struct flock lock = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
  const int file = open(path, O_RDWR | O_CREAT, 0666);
  while (file >= 0 && fcntl(file, F_SETLKW, &lock) != 0 && errno == EINTR) {
  }
  return file;
}

void launcher_await_lock(const char *path) {
  const int file = take_lock(path);
  if (file >= 0) close(file);
}

/* In the new process. */
static void become(const Launcher *launcher, const Job *job, pid_t parent) {
  stop_with_parent(parent);
  if (take_lock(job->lock) >= 0 && redirect(STDIN_FILENO, "/dev/null", O_RDONLY) &&
      redirect(STDOUT_FILENO, "/dev/null", O_WRONLY) &&
      redirect(STDERR_FILENO, job->messages, O_WRONLY | O_CREAT | O_TRUNC) &&
      setenv("MLAW_PLUGIN_PATH", job->plugin_path, 1) == 0)
    execv(launcher->program, job->arguments);
  _exit(CANNOT_START);
}

static Status start_here(Launcher *launcher, int slot, const Job *job, Error *error) {
  const pid_t parent = getpid(), process = fork();
  if (process < 0) return error_set(error, STATUS_FAILED, "a process cannot be started: %s", strerror(errno));
  if (process == 0) become(launcher, job, parent);
  launcher->process[slot] = process;
  return STATUS_OK;
}

static JobEnd end_of(int slot, int how) {
  if (WIFSIGNALED(how)) return (JobEnd){.slot = slot, .code = -1, .signal = WTERMSIG(how)};
  return (JobEnd){.slot = slot, .code = WEXITSTATUS(how)};
}

static JobEnd poll_here(Launcher *launcher) {
  for (int slot = 0; slot < launcher->slots; slot++) {
    int how;
    const pid_t process = launcher->process[slot];
    if (process == 0 || waitpid(process, &how, WNOHANG) != process) continue;
    launcher->process[slot] = 0;
    return end_of(slot, how);
  }
  return (JobEnd){.slot = -1};
}

static void stop_here(Launcher *launcher) {
  for (int slot = 0; slot < launcher->slots; slot++)
    if (launcher->process[slot] > 0) kill(launcher->process[slot], SIGTERM);
}

static void wait_a_moment(void) {
  static const struct timespec moment = {.tv_nsec = 2000000};
  nanosleep(&moment, NULL);
}

/* ---- rank 0 ---- */

static Status append_with_end(Text *bytes, const char *text, Error *error) {
  return text_append_bytes(bytes, error, text, strlen(text) + 1);
}

static Status start_there(int rank, int slot, const Job *job, Error *error) {
  Status status = STATUS_OK;
  Text bytes = {0};
  TRY(text_append(&bytes, error, "%d", slot));
  TRY(append_with_end(&bytes, "", error));
  TRY(append_with_end(&bytes, job->lock, error));
  TRY(append_with_end(&bytes, job->messages, error));
  TRY(append_with_end(&bytes, job->plugin_path, error));
  for (size_t i = 0; job->arguments[i]; i++) TRY(append_with_end(&bytes, job->arguments[i], error));
  ranks_send(rank, MESSAGE_JOB, bytes.data, bytes.length);
cleanup:
  text_free(&bytes);
  return status;
}

Status launcher_start(Launcher *launcher, int slot, const Job *job, Error *error) {
  const int rank = slot / launcher->slots;
  return rank == 0 ? start_here(launcher, slot, job, error)
                   : start_there(rank, slot % launcher->slots, job, error);
}

Status launcher_poll(Launcher *launcher, JobEnd *end, Error *error) {
  Status status = STATUS_OK;
  Message message = {.bytes = {0}};
  bool received = false;
  *end = poll_here(launcher);
  if (end->slot >= 0) return STATUS_OK;
  TRY(ranks_receive(&message, &received, error));
  if (!received) {
    wait_a_moment();
  } else if (message.kind == MESSAGE_END &&
             sscanf(message.bytes.data, "%d %d %d", &end->slot, &end->code, &end->signal) == 3) {
    end->slot += message.rank * launcher->slots;
  }
cleanup:
  text_free(&message.bytes);
  return status;
}

static void tell_all(MessageKind kind) {
  for (int rank = 1; ranks_own() == 0 && rank < ranks_count(); rank++) ranks_send(rank, kind, "", 0);
}

void launcher_stop(Launcher *launcher) {
  stop_here(launcher);
  tell_all(MESSAGE_STOP);
}

/* ---- the other ranks ---- */

static size_t count_texts(const Text *bytes) {
  size_t n = 0;
  for (size_t i = 0; i < bytes->length; i++) n += bytes->data[i] == '\0';
  return n;
}

static Status start_received(Launcher *launcher, Text *bytes, Error *error) {
  enum { SLOT, LOCK, MESSAGES, PLUGIN_PATH, ARGUMENTS };
  Status status = STATUS_OK;
  char **text = NULL, *at = bytes->data;
  const size_t n = count_texts(bytes);
  TRY(ARRAY_NEW(&text, n + 1, error));
  for (size_t i = 0; i < n; i++, at += strlen(at) + 1) text[i] = at;
  TRY(start_here(launcher, atoi(text[SLOT]),
                 &(Job){text + ARGUMENTS, text[LOCK], text[MESSAGES], text[PLUGIN_PATH]}, error));
cleanup:
  array_free(text);
  return status;
}

static void report_ends(Launcher *launcher) {
  for (JobEnd end; (end = poll_here(launcher)).slot >= 0;) {
    char text[64];
    const int length = snprintf(text, sizeof text, "%d %d %d", end.slot, end.code, end.signal);
    ranks_send(0, MESSAGE_END, text, (size_t)length);
  }
}

Status launcher_serve(Launcher *launcher, const volatile int *interrupt, Error *error) {
  Status status = STATUS_OK;
  Message message = {.bytes = {0}};
  for (bool stopped = false;;) {
    bool received;
    text_free(&message.bytes);
    TRY(ranks_receive(&message, &received, error));
    if (received && message.kind == MESSAGE_QUIT) break;
    if (received && message.kind == MESSAGE_JOB) TRY(start_received(launcher, &message.bytes, error));
    if ((received && message.kind == MESSAGE_STOP) || (*interrupt && !stopped)) {
      stop_here(launcher);
      stopped = true;
    }
    report_ends(launcher);
    if (!received) wait_a_moment();
  }
cleanup:
  text_free(&message.bytes);
  return status;
}

/* ---- the end ---- */

void launcher_free(Launcher *launcher) {
  if (!launcher) return;
  if (launcher->process) {
    launcher_stop(launcher);
    for (int slot = 0; slot < launcher->slots; slot++)
      while (launcher->process[slot] > 0 && waitpid(launcher->process[slot], NULL, 0) < 0 && errno == EINTR) {
      }
  }
  array_free(launcher->process);
  array_free(launcher);
}
