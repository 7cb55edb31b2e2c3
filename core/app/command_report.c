/* capsella report: a picture of the last state in a folder of results. */
#include "app/commands.h"
#include "app/help.h"
#include "run/report.h"
#include "study/study_page.h"
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static Status report_study(const char *folder, Text *written, Error *error) {
  Status status;
  TRY(study_page_write(folder, error));
  TRY(text_append(written, error, "%s/report.html", folder));
cleanup:
  return status;
}

int command_report(int argc, char **argv) {
  if (argc != 2 || argv[1][0] == '-')
    return help_refuse("report", "expected one folder", argc > 1 ? argv[argc - 1] : NULL);
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
