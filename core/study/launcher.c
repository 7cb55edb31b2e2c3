/* fork and exec.  A process whose parent dies, however that happens, is asked to stop where the system can do
 * that; and where two meet in one folder all the same, a lock makes the later one wait. */
#include "study/launcher.h"

#include "base/array.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
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
  int slots;
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
  return launcher->slots;
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

Status launcher_start(Launcher *launcher, int slot, const Job *job, Error *error) {
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

JobEnd launcher_poll(Launcher *launcher) {
  static const struct timespec moment = {.tv_nsec = 2000000};
  for (int slot = 0; slot < launcher->slots; slot++) {
    int how;
    const pid_t process = launcher->process[slot];
    if (process == 0 || waitpid(process, &how, WNOHANG) != process) continue;
    launcher->process[slot] = 0;
    return end_of(slot, how);
  }
  nanosleep(&moment, NULL);
  return (JobEnd){.slot = -1};
}

void launcher_stop(Launcher *launcher) {
  for (int slot = 0; slot < launcher->slots; slot++)
    if (launcher->process[slot] > 0) kill(launcher->process[slot], SIGTERM);
}

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
