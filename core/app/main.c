/* The program: picks the subcommand. */
#include "app/commands.h"
#include "app/help.h"
#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int command_help(int argc, char **argv);

static const struct {
  const char *name;
  int (*run)(int argc, char **argv);
  bool serial; /* computes nothing in threads, so it need not set them up */
} COMMANDS[] = {
    {"run", command_run, false},      {"study", command_study, true}, {"laws", command_laws, true},
    {"report", command_report, true}, {"maps", command_maps, true},   {"bench", command_bench, false},
    {"manual", command_manual, true}, {"help", command_help, true},
};
enum { N_COMMANDS = sizeof COMMANDS / sizeof *COMMANDS };

int exit_code(Status status) {
  if (status == STATUS_OK) return EXIT_DONE;
  return status == STATUS_INPUT ? EXIT_INPUT : EXIT_FAILED;
}

static int print_help(const HelpPage *page) {
  Text text = {0};
  Error error;
  const Status status = help_print(page, &text, &error);
  if (status == STATUS_OK)
    fputs(text.data, stdout);
  else
    fprintf(stderr, "%s\n", error.text);
  text_free(&text);
  return exit_code(status);
}

static int unknown_command(const char *name) {
  const char *nearest = help_nearest("", name);
  fprintf(stderr, "capsella: expected a command, found '%s'", name);
  if (nearest) fprintf(stderr, "; did you mean '%s'?", nearest);
  if (strstr(name, ".yaml"))
    fprintf(stderr, "; 'capsella run %s' runs a scene, 'capsella study' a study", name);
  fprintf(stderr, "\nTry: capsella --help\n");
  return EXIT_INPUT;
}

static int command_help(int argc, char **argv) {
  const HelpPage *page = help_find(argc - 1, argv + 1);
  return page ? print_help(page) : unknown_command(argv[1]);
}

/* Whether the arguments ask for the help of their command. */
static bool asks_for_help(int argc, char **argv) {
  for (int i = 1; i < argc; i++)
    if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) return true;
  return false;
}

/* A standard stream that the caller has closed leaves its number to the next file that is opened, and
 * messages would end up in results. */
static void fill_standard_streams(void) {
  int file;
  do file = open("/dev/null", O_RDWR);
  while (file >= 0 && file <= STDERR_FILENO);
  if (file >= 0) close(file);
}

/* Threads that wait should sleep: when they spin, as the OpenMP library does by default, a machine with
 * anything else to do runs two threads slower than one.  And a BLAS with threads of its own has nothing here
 * worth keeping them busy for. Both libraries read their settings before main, so the program starts itself
 * anew once, for commands that compute; settings of the user's stand. */
static void let_threads_sleep(char **argv) {
  if (getenv("OMP_WAIT_POLICY")) return;
  setenv("OPENBLAS_NUM_THREADS", "1", 0);
  if (setenv("OMP_WAIT_POLICY", "passive", 1) == 0)
    execv("/proc/self/exe", argv); /* returns only on failure */
}

static int run_command(int argc, char **argv) {
  if (argc < 2 || strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
    const int code = print_help(help_page(""));
    return argc < 2 ? EXIT_INPUT : code;
  }
  if (strcmp(argv[1], "--version") == 0) {
    puts("capsella " CAPSELLA_VERSION);
    return EXIT_DONE;
  }
  for (size_t i = 0; i < N_COMMANDS; i++) {
    if (strcmp(argv[1], COMMANDS[i].name) != 0) continue;
    if (asks_for_help(argc - 1, argv + 1)) return print_help(help_find(argc - 1, argv + 1));
    if (!COMMANDS[i].serial) let_threads_sleep(argv);
    return COMMANDS[i].run(argc - 1, argv + 1);
  }
  return unknown_command(argv[1]);
}

/* What was printed and did not arrive, on a full disk or a closed pipe, is a failure. */
int main(int argc, char **argv) {
  fill_standard_streams();
  const int code = run_command(argc, argv);
  if (fflush(stdout) == 0 && !ferror(stdout)) return code;
  fprintf(stderr, "capsella: the standard output cannot be written: %s\n", strerror(errno));
  return code == EXIT_DONE ? EXIT_FAILED : code;
}
