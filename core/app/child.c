#include "app/child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct {
  ChildWork *work;
  void *context;
  unsigned seconds;
} Job;

/* What a plugin prints must not spoil the answer, nor the terminal. */
static void silence(void) {
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

static void be_child(const Job *job, int pipe_end) {
  FILE *answer = stdout;
  signal(SIGALRM, SIG_DFL);
  alarm(job->seconds);
  if (pipe_end >= 0) {
    silence();
    answer = fdopen(pipe_end, "w");
    if (!answer) _exit(EXIT_FAILURE);
  }
  const int code = job->work(job->context, answer);
  if (fflush(answer) != 0 || ferror(answer)) _exit(EXIT_FAILURE);
  if (pipe_end >= 0) _exit(code); /* what a plugin does at the end of its process is no part of the answer */
  exit(code);
}

static Status read_answer(int pipe_end, Text *answer, Error *error) {
  char part[4096];
  for (;;) {
    const ssize_t n = read(pipe_end, part, sizeof part);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return STATUS_OK; /* how the child ended says whether it is whole */
    const Status status = text_append_bytes(answer, error, part, (size_t)n);
    if (status != STATUS_OK) return status;
  }
}

static bool is_crash(int number) {
  return number == SIGSEGV || number == SIGBUS || number == SIGFPE || number == SIGILL || number == SIGABRT ||
         number == SIGSYS || number == SIGTRAP || number == SIGKILL;
}

static Status judge(int ended, unsigned seconds, int *code, Error *error) {
  if (WIFEXITED(ended)) {
    *code = WEXITSTATUS(ended);
    return STATUS_OK;
  }
  const int number = WTERMSIG(ended);
  if (number == SIGALRM) return error_set(error, STATUS_FAILED, "did not come back within %u s", seconds);
  if (!is_crash(number)) raise(number);
  return error_set(error, STATUS_FAILED, "crashed (signal %d, %s)", number, strsignal(number));
}

static Status fork_child(const Job *job, const int ends[2], pid_t *child, Error *error) {
  fflush(stdout); /* or the child would print it, too */
  fflush(stderr);
  *child = fork();
  if (*child < 0) return error_set(error, STATUS_IO, "a process cannot be started: %s", strerror(errno));
  if (*child == 0) {
    if (ends[0] >= 0) close(ends[0]);
    be_child(job, ends[1]);
  }
  return STATUS_OK;
}

Status child_run(ChildWork *work, void *context, unsigned seconds, Text *answer, int *code, Error *error) {
  Status status = STATUS_OK;
  const Job job = {work, context, seconds};
  int ends[2] = {-1, -1}, ended = 0;
  pid_t child = -1;
  if (answer && pipe(ends) != 0)
    TRY(error_set(error, STATUS_IO, "a pipe cannot be had: %s", strerror(errno)));
  TRY(fork_child(&job, ends, &child, error));
  if (answer) {
    close(ends[1]);
    ends[1] = -1;
    status = read_answer(ends[0], answer, error);
    if (status != STATUS_OK) kill(child, SIGKILL);
  }
  while (waitpid(child, &ended, 0) < 0 && errno == EINTR) continue;
  if (status == STATUS_OK) status = judge(ended, seconds, code, error);
cleanup:
  for (int k = 0; k < 2; k++)
    if (ends[k] >= 0) close(ends[k]);
  return status;
}
