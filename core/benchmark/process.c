#include "benchmark/process.h"

#include "base/array.h"
#include "base/timer.h"
#include <fcntl.h>
#include <spawn.h>
#include <stdbool.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { TIMES = 5 };

extern char **environ;

/* The program puts this into its own environment and starts anew (core/app/main.c), which belongs to what is
 * measured. */
static bool is_own_setting(const char *variable) {
  return strncmp(variable, "OMP_WAIT_POLICY=", 16) == 0;
}

static Status user_environment(char ***variables, Error *error) {
  size_t n = 0, kept = 0;
  while (environ[n]) n++;
  Status status = ARRAY_NEW(variables, n + 1, error);
  for (size_t k = 0; status == STATUS_OK && k < n; k++)
    if (!is_own_setting(environ[k])) (*variables)[kept++] = environ[k];
  return status;
}

static double child_seconds(void) {
  struct rusage usage;
  getrusage(RUSAGE_CHILDREN, &usage);
  return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

static Status run_child(char *const *argv, char *const *variables, Error *error) {
  posix_spawn_file_actions_t actions;
  pid_t child;
  int code, ended = 0;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  code = posix_spawn(&child, argv[0], &actions, NULL, argv, variables);
  posix_spawn_file_actions_destroy(&actions);
  if (code != 0) return error_set(error, STATUS_FAILED, "%s: cannot be started: %s", argv[0], strerror(code));
  waitpid(child, &ended, 0);
  if (WIFEXITED(ended) && WEXITSTATUS(ended) == 0) return STATUS_OK;
  return error_set(error, STATUS_FAILED, "%s %s: expected to end with 0, found %d", argv[0],
                   argv[1] ? argv[1] : "", WIFEXITED(ended) ? WEXITSTATUS(ended) : -WTERMSIG(ended));
}

/* execve and its kin want arguments that are not const, but leave them alone. */
static Status copy_arguments(const char *const *argv, char ***arguments, Error *error) {
  size_t n = 0;
  while (argv[n]) n++;
  const Status status = ARRAY_NEW(arguments, n + 1, error);
  if (status == STATUS_OK) memcpy(*arguments, argv, n * sizeof *argv);
  return status;
}

Status process_measure(const char *const *argv, ProcessCost *cost, Error *error) {
  Status status = STATUS_OK;
  char **variables = NULL, **arguments = NULL;
  double wall[TIMES], cpu[TIMES];
  TRY(user_environment(&variables, error));
  TRY(copy_arguments(argv, &arguments, error));
  for (int k = 0; k < TIMES; k++) {
    const double start = timer_wall_seconds(), used = child_seconds();
    TRY(run_child(arguments, variables, error));
    wall[k] = timer_wall_seconds() - start;
    cpu[k] = child_seconds() - used;
  }
  *cost = (ProcessCost){timer_median(wall, TIMES), timer_median(cpu, TIMES)};
cleanup:
  array_free(variables);
  array_free(arguments);
  return status;
}
