#include "run/report.h"

#include "base/file.h"
#include "run/report_curves.h"
#include "run/run_page.h"

static Status write(const char *folder, const char *name, const Text *svg, Text *written, Error *error) {
  Status status;
  Text path = {0};
  TRY(file_join(&path, folder, name, error));
  TRY(file_write(path.data, svg->data, svg->length, error));
  TRY(text_append(written, error, "%s\n", path.data));
cleanup:
  text_free(&path);
  return status;
}

Status report_folder(const char *folder, const ReportChoice *choice, Text *written, Error *error) {
  Status status;
  Text svg = {0};
  TRY(report_picture(folder, choice, &svg, error));
  TRY(write(folder, "capsule.svg", &svg, written, error));
  svg.length = 0;
  TRY(report_curves(folder, &svg, error));
  TRY(write(folder, "curves.svg", &svg, written, error));
  TRY(run_page_write(folder, NULL, error));
  TRY(text_append(written, error, "%s/report.html", folder));
cleanup:
  text_free(&svg);
  return status;
}
