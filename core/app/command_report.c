/* capsella report: a picture of the last state in a folder of results. */
#include "app/commands.h"
#include "run/report.h"
#include "study/study_page.h"
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static const char USAGE[] =
    "usage: capsella report DIR\n"
    "\n"
    "Draws the newest snapshot of DIR into DIR/capsule.svg, coloured by damage, and writes\n"
    "the page DIR/report.html.  Of a study's folder, it makes the page.\n";

static Status report_study(const char *folder, Text *written, Error *error) {
  Status status;
  TRY(study_page_write(folder, error));
  TRY(text_append(written, error, "%s/report.html", folder));
cleanup:
  return status;
}

int command_report(int argc, char **argv) {
  const bool help = argc == 2 && (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0);
  if (argc != 2 || help || argv[1][0] == '-') {
    fputs(USAGE, help ? stdout : stderr);
    return help ? EXIT_DONE : EXIT_INPUT;
  }
  Text written = {0};
  Error error;
  const Status status = study_page_is_study(argv[1]) ? report_study(argv[1], &written, &error)
                                                     : report_folder(argv[1], &written, &error);
  if (status == STATUS_OK)
    printf("%s\n", written.data);
  else
    fprintf(stderr, "%s\n", error.text);
  text_free(&written);
  return exit_code(status);
}
