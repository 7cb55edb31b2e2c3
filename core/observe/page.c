/* The data go where the template has its mark. */
#include "observe/page.h"

#include "base/file.h"
#include <string.h>

static const char MARK[] = "@CAPSELLA_DATA@";

/* web/report_page.html, ended by a NUL (page_template.S). */
extern const char page_template[];

/* The data stand in a script element, which "</script>" or "<!--" in a name would end: no '<' is left. */
static Status append_data(const char *data, Text *html, Error *error) {
  Status status = STATUS_OK;
  for (const char *next; status == STATUS_OK && (next = strchr(data, '<')); data = next + 1) {
    TRY(text_append_bytes(html, error, data, (size_t)(next - data)));
    TRY(text_append(html, error, "\\u003c"));
  }
  TRY(text_append_bytes(html, error, data, strlen(data)));
cleanup:
  return status;
}

Status page_print(const char *data, Text *html, Error *error) {
  Status status = STATUS_OK;
  const char *mark = strstr(page_template, MARK);
  if (!mark) return error_set(error, STATUS_FAILED, "the page has no place for data");
  TRY(text_append_bytes(html, error, page_template, (size_t)(mark - page_template)));
  TRY(append_data(data, html, error));
  mark += strlen(MARK);
  TRY(text_append_bytes(html, error, mark, strlen(mark)));
cleanup:
  return status;
}

Status page_write(const char *folder, const char *data, Error *error) {
  Status status = STATUS_OK;
  Text path = {0}, html = {0};
  TRY(file_join(&path, folder, "report.html", error));
  TRY(page_print(data, &html, error));
  TRY(file_write(path.data, html.data, html.length, error));
cleanup:
  text_free(&path);
  text_free(&html);
  return status;
}
