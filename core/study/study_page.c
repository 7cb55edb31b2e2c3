/* The cases are the folders in cases/, by name: their last states are shown, in the order of the table. */
#include "study/study_page.h"

#include "base/array.h"
#include "base/file.h"
#include "observe/page.h"
#include "observe/snapshot.h"
#include "run/page_surfaces.h"
#include <dirent.h>
#include <stdlib.h>
#include <string.h>

/* The cases of a folder that have a state to show. */
typedef struct {
  PageState *states; /* [capacity] */
  size_t count, capacity;
} Cases;

static void cases_free(Cases *cases) {
  for (size_t k = 0; k < cases->count; k++) {
    array_free(cases->states[k].path);
    array_free(cases->states[k].label);
  }
  array_free(cases->states);
}

static bool has_file(const char *folder, const char *name) {
  Text path = {0};
  Error ignored;
  const bool found = file_join(&path, folder, name, &ignored) == STATUS_OK && file_exists(path.data);
  text_free(&path);
  return found;
}

bool study_page_is_study(const char *folder) {
  return has_file(folder, "table.csv") && has_file(folder, "scene.yaml");
}

static int by_label(const void *a, const void *b) {
  return strcmp(((const PageState *)a)->label, ((const PageState *)b)->label);
}

/* Takes the case NAME in when it has a snapshot. */
static Status add_case(Cases *cases, const char *parent, const char *name, Error *error) {
  Status status = STATUS_OK;
  Text folder = {0}, path = {0};
  int number = -1;
  PageState *state = &cases->states[cases->count];
  TRY(file_join(&folder, parent, name, error));
  if (!has_file(folder.data, "resolved.yaml")) goto cleanup;
  if (snapshot_find_newest(folder.data, &path, &number, NULL, error) != STATUS_OK || number < 0) goto cleanup;
  if (!(state->path = text_copy(path.data, error))) TRY(error->code);
  cases->count++; /* from here on freed with the others */
  if (!(state->label = text_copy(name, error))) TRY(error->code);
cleanup:
  text_free(&folder);
  text_free(&path);
  return status;
}

static Status find_cases(Cases *cases, const char *parent, Error *error) {
  Status status = STATUS_OK;
  DIR *entries = opendir(parent);
  if (!entries) return STATUS_OK; /* a study that has run nothing yet */
  while (readdir(entries)) cases->capacity++;
  rewinddir(entries);
  TRY(ARRAY_NEW(&cases->states, cases->capacity, error));
  for (struct dirent *entry; cases->count < cases->capacity && (entry = readdir(entries));)
    if (entry->d_name[0] != '.') TRY(add_case(cases, parent, entry->d_name, error));
  qsort(cases->states, cases->count, sizeof *cases->states, by_label);
cleanup:
  closedir(entries);
  return status;
}

/* The flow is the same in all cases, or at least in the first one. */
static Status put_cases(Page *page) {
  Status status = STATUS_OK;
  Cases cases = {0};
  Scene scene = {0};
  Text parent = {0}, resolved = {0};
  TRY(file_join(&parent, page->folder, "cases", page->error));
  TRY(find_cases(&cases, parent.data, page->error));
  if (cases.count > 0) {
    TRY(text_append(&resolved, page->error, "%s/%s/resolved.yaml", parent.data, cases.states[0].label));
    TRY(scene_read(&scene, resolved.data, NULL, 0, page->error));
  }
  TRY(page_put_surfaces(page, &scene, cases.states, cases.count, NULL));
  if (cases.count > 0) json_numbers(&page->json, "gradient", scene.flow.gradient[0], 9);
cleanup:
  cases_free(&cases);
  scene_free(&scene);
  text_free(&parent);
  text_free(&resolved);
  return status;
}

Status study_page_write(const char *folder, Error *error) {
  Status status = STATUS_OK;
  Page page;
  page_begin(&page, "study", folder, error);
  TRY(page_put_json(&page, "summary", "summary.json"));
  TRY(page_put_text(&page, "table", "table.csv"));
  TRY(page_put_text(&page, "scene", "scene.yaml"));
  TRY(put_cases(&page));
  TRY(page_end(&page));
cleanup:
  page_free(&page);
  return status;
}
