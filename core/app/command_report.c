/* capsella report: pictures and page from a folder of results. */
#include "app/commands.h"
#include "app/help.h"
#include "run/report.h"
#include "study/study_page.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static Status report_study(const char *folder, Text *written, Error *error) {
  Status status;
  TRY(study_page_write(folder, error));
  TRY(text_append(written, error, "%s/report.html", folder));
cleanup:
  return status;
}

static int refuse(const char *what, const char *found) {
  return help_refuse("report", what, found);
}

/* -1 to go on, an exit code otherwise. */
static int parse(int argc, char **argv, const char **folder, ReportChoice *choice) {
  for (int i = 1; i < argc; i++) {
    const char *argument = argv[i], *value = i + 1 < argc ? argv[i + 1] : NULL;
    char *end = NULL;
    if (strcmp(argument, "--color") == 0) {
      if (!value) return refuse("--color needs a field", NULL);
      choice->field = argv[++i];
    } else if (strcmp(argument, "--time") == 0) {
      choice->time = value ? strtod(value, &end) : NAN;
      if (!isfinite(choice->time) || end == value || *end) return refuse("--time needs a number", value);
      i++;
    } else if (argument[0] == '-') {
      return refuse("expected an option of the usage below", argument);
    } else if (*folder) {
      return refuse("expected one folder", argument);
    } else {
      *folder = argument;
    }
  }
  return *folder ? -1 : refuse("expected the folder of a run or of a study", NULL);
}

/* Why a place cannot be the folder of a run; NULL: it may be one. */
static const char *objection(const char *folder) {
  struct stat found;
  if (stat(folder, &found) != 0) return "there is none";
  return S_ISDIR(found.st_mode) ? NULL : "it is a file";
}

int command_report(int argc, char **argv) {
  const char *folder = NULL;
  ReportChoice choice = {.time = NAN};
  const int code = parse(argc, argv, &folder, &choice);
  if (code >= 0) return code;
  Text written = {0};
  Error error;
  Status status;
  if (objection(folder))
    status = error_set(&error, STATUS_INPUT, "%s: expected the folder of a run or of a study; %s", folder,
                       objection(folder));
  else if (study_page_is_study(folder))
    status = report_study(folder, &written, &error);
  else
    status = report_folder(folder, &choice, &written, &error);
  if (status == STATUS_OK)
    printf("%s\n", written.data);
  else
    fprintf(stderr, "%s\n", error.text);
  text_free(&written);
  return exit_code(status);
}
