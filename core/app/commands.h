/* The subcommands: each gets its own name as argv[0] and returns the exit code. */
#ifndef CAPSELLA_APP_COMMANDS_H
#define CAPSELLA_APP_COMMANDS_H

#include "base/status.h"

enum { EXIT_DONE = 0, EXIT_FAILED = 1, EXIT_INPUT = 2 };

int command_run(int argc, char **argv);
int command_laws(int argc, char **argv);
int command_laws_check(int argc, char **argv); /* of command_laws: argv[0] = "check" */
int command_laws_show(int argc, char **argv);  /* the same with "show" */
int command_laws_new(int argc, char **argv);   /* the same with "new" */
int command_laws_plot(int argc, char **argv);  /* the same with "plot" */
int command_study(int argc, char **argv);
int command_report(int argc, char **argv);
int command_maps(int argc, char **argv);
int command_bench(int argc, char **argv);
int command_manual(int argc, char **argv);

/* 2 when the input is wrong, 1 when something else failed, 0 when nothing did. */
int exit_code(Status status);

#endif
