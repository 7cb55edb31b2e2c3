/* The data go where the template has its mark. */
#include "observe/page.h"

#include "base/file.h"
#include <string.h>

static const char MARK[] = "@CAPSELLA_DATA@";
static const size_t LARGEST_FILE = (size_t)1 << 30;

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

void page_begin(Page *page, const char *kind, const char *folder, Error *error) {
  *page = (Page){.folder = folder, .error = error};
  json_begin(&page->json, &page->data, error);
  json_open_object(&page->json, NULL);
  json_string(&page->json, "kind", kind);
  json_string(&page->json, "program", CAPSELLA_VERSION);
}

void page_free(Page *page) {
  text_free(&page->data);
}

Status page_read(const Page *page, const char *name, Text *text) {
  Text path = {0};
  Status status = file_join(&path, page->folder, name, page->error);
  if (status == STATUS_OK && file_exists(path.data))
    status = file_read(path.data, LARGEST_FILE, text, page->error);
  text_free(&path);
  return status;
}

Status page_put_text(Page *page, const char *key, const char *name) {
  Text text = {0};
  const Status status = page_read(page, name, &text);
  if (status == STATUS_OK) json_string(&page->json, key, text.data);
  text_free(&text);
  return status;
}

Status page_put_json(Page *page, const char *key, const char *name) {
  Text text = {0};
  const Status status = page_read(page, name, &text);
  if (status == STATUS_OK) json_raw(&page->json, key, text.length > 0 ? text.data : "null");
  text_free(&text);
  return status;
}

Status page_end(Page *page) {
  Status status = STATUS_OK;
  Text path = {0}, html = {0};
  json_close(&page->json);
  TRY(json_end(&page->json));
  TRY(file_join(&path, page->folder, "report.html", page->error));
  TRY(page_print(page->data.data, &html, page->error));
  TRY(file_write(path.data, html.data, html.length, page->error));
cleanup:
  text_free(&path);
  text_free(&html);
  return status;
}
