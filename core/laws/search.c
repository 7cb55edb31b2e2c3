/* Folders and files of plugins, through POSIX glob and the table of what the process has mapped.  Nothing
 * here opens a plugin. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "laws/search.h"

#include "base/array.h"
#include "base/file.h"
#include "base/text.h"
#include <glob.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Appends a copy of `string` to a list of n strings; the list grows by doubling at powers of two. */
static Status append(char ***list, size_t *n, const char *string, Error *error) {
  size_t count = *n;
  if ((count & (count - 1)) == 0) {
    char **grown = array_allocate(count ? 2 * count : 1, sizeof *grown, "list of files", error);
    if (!grown) return error->code;
    if (count) memcpy(grown, *list, count * sizeof *grown);
    array_free(*list);
    *list = grown;
  }
  if (!((*list)[count] = text_copy(string, error))) return error->code;
  *n = count + 1;
  return STATUS_OK;
}

static void free_list(char **list, size_t n) {
  for (size_t i = 0; i < n; i++) array_free(list[i]);
  array_free(list);
}

static Status add_folder(LawSearch *search, const char *folder, Error *error) {
  if (!*folder) return STATUS_OK;
  for (size_t i = 0; i < search->n; i++) {
    if (strcmp(search->folder[i], folder) == 0) return STATUS_OK;
  }
  return append(&search->folder, &search->n, folder, error);
}

static Status add_environment(LawSearch *search, const char *path, Error *error) {
  Status status = STATUS_OK;
  Text entry = {0};
  while (path && status == STATUS_OK) {
    const char *colon = strchr(path, ':');
    size_t length = colon ? (size_t)(colon - path) : strlen(path);
    entry.length = 0;
    TRY(text_append(&entry, error, "%.*s", (int)length, path));
    TRY(add_folder(search, entry.data, error));
    path = colon ? colon + 1 : NULL;
  }
cleanup:
  text_free(&entry);
  return status;
}

/* The folder as a glob pattern that matches itself alone. */
static Status append_literally(Text *pattern, const char *folder, Error *error) {
  Status status = STATUS_OK;
  for (const char *c = folder; *c && status == STATUS_OK; c++) {
    status = text_append(pattern, error, strchr("*?[\\", *c) ? "\\%c" : "%c", *c);
  }
  return status;
}

/* Calls `add` on each path that matches folder + tail, in alphabetical order. */
static Status for_each_match(const char *folder, const char *tail,
                             Status (*add)(void *list, const char *path, Error *error), void *list,
                             Error *error) {
  Status status;
  Text pattern = {0};
  glob_t match = {0};
  TRY(append_literally(&pattern, folder, error));
  TRY(text_append(&pattern, error, "%s", tail));
  if (glob(pattern.data, 0, NULL, &match) == GLOB_NOSPACE) {
    TRY(error_set(error, STATUS_MEMORY, "out of memory while reading the folder %s", folder));
  }
  for (size_t i = 0; i < match.gl_pathc; i++) TRY(add(list, match.gl_pathv[i], error));
cleanup:
  globfree(&match);
  text_free(&pattern);
  return status;
}

static Status add_matching_folder(void *search, const char *path, Error *error) {
  return add_folder(search, path, error);
}

/* The file that this code is in, the program or a shared library: the one mapped where this function lies. */
static Status find_own_file(Text *path, Error *error) {
  Status status = STATUS_OK;
  const uintptr_t here = (uintptr_t)&find_own_file;
  char line[4352]; /* of /proc/self/maps: BEGIN-END MODE OFFSET DEVICE INODE FILE */
  FILE *maps = fopen("/proc/self/maps", "r");
  if (!maps) return STATUS_OK; /* no such table here: scene and environment must do */
  while (fgets(line, sizeof line, maps)) {
    uintptr_t begin, end;
    if (sscanf(line, "%" SCNxPTR "-%" SCNxPTR, &begin, &end) != 2 || here < begin || here >= end) continue;
    const char *file = strchr(line, '/');
    if (file) TRY(text_append(path, error, "%.*s", (int)strcspn(file, "\n"), file));
    break;
  }
cleanup:
  fclose(maps);
  return status;
}

/* The plugins that belong to this file: in the build tree, or installed under the same prefix. */
static Status add_own_folders(LawSearch *search, Error *error) {
  Status status = STATUS_OK;
  Text file = {0}, folder = {0}, beside = {0}, below = {0}, prefix = {0};
  TRY(find_own_file(&file, error));
  if (!file.data) goto cleanup;
  TRY(file_folder(&folder, file.data, error));
  TRY(file_folder(&prefix, folder.data, error));
  TRY(file_join(&beside, folder.data, "plugins", error));
  TRY(file_join(&below, folder.data, "capsella/plugins", error));
  TRY(add_folder(search, beside.data, error));
  TRY(for_each_match(below.data, "", add_matching_folder, search, error));
  TRY(for_each_match(prefix.data, "/lib*/capsella/plugins", add_matching_folder, search, error));
  TRY(for_each_match(prefix.data, "/lib/*/capsella/plugins", add_matching_folder, search, error));
cleanup:
  text_free(&prefix);
  text_free(&below);
  text_free(&beside);
  text_free(&folder);
  text_free(&file);
  return status;
}

Status law_search_default(LawSearch *search, const char *scene_folder, Error *error) {
  Status status = STATUS_OK;
  *search = (LawSearch){0};
  if (scene_folder) TRY(add_folder(search, scene_folder, error));
  TRY(add_environment(search, getenv("MLAW_PLUGIN_PATH"), error));
  search->n_foreign = search->n;
  TRY(add_own_folders(search, error));
cleanup:
  if (status != STATUS_OK) law_search_free(search);
  return status;
}

void law_search_free(LawSearch *search) {
  free_list(search->folder, search->n);
  *search = (LawSearch){0};
}

/* A folder of the program that the environment names, too, is the environment's: its laws are checked. */
bool law_search_owns(const LawSearch *search, const char *file) {
  bool owned = false;
  const size_t length = (size_t)(strrchr(file, '/') - file);
  for (size_t i = search->n_foreign; i < search->n && !owned; i++) {
    char *folder = realpath(search->folder[i], NULL);
    owned = folder && strlen(folder) == length && strncmp(folder, file, length) == 0;
    free(folder);
  }
  return owned;
}

static Status add_file(void *list, const char *path, Error *error) {
  LawFiles *files = list;
  Status status = STATUS_OK;
  size_t n = files->n;
  Text name = {0};
  const char *base = strrchr(path, '/') + 1;
  TRY(text_append(&name, error, "%.*s", (int)(strlen(base) - strlen(".so")), base));
  TRY(append(&files->name, &n, name.data, error));
  status = append(&files->path, &files->n, path, error);
  if (status != STATUS_OK) array_free(files->name[files->n]);
cleanup:
  text_free(&name);
  return status;
}

Status law_search_files(const LawSearch *search, LawFiles *files, Error *error) {
  Status status = STATUS_OK;
  *files = (LawFiles){0};
  for (size_t i = 0; i < search->n; i++) {
    TRY(for_each_match(search->folder[i], "/*.so", add_file, files, error));
  }
cleanup:
  if (status != STATUS_OK) law_files_free(files);
  return status;
}

void law_files_free(LawFiles *files) {
  free_list(files->path, files->n);
  free_list(files->name, files->n);
  *files = (LawFiles){0};
}
