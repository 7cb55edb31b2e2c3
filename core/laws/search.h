/* Where law plugins are looked for: an ordered list of folders, never searched recursively. */
#ifndef CAPSELLA_LAWS_SEARCH_H
#define CAPSELLA_LAWS_SEARCH_H

#include "base/status.h"
#include <stddef.h>

/* Folders in the order they are searched; made by law_search_default. */
typedef struct {
  char **folder;
  size_t n;
} LawSearch;

/* The scene's folder (may be NULL), then MLAW_PLUGIN_PATH (colon-separated), then `plugins` beside the
 * program (build tree), then the capsella/plugins of a library folder beside the program's (installed).
 * Duplicates, empty entries and folders that do not exist are dropped. */
Status law_search_default(LawSearch *search, const char *scene_folder, Error *error);
void law_search_free(LawSearch *search);

/* Plugin files: path, and name without folder and `.so`; made by law_search_files. */
typedef struct {
  char **path, **name;
  size_t n;
} LawFiles;

/* Every `*.so` of the folders, in search order and alphabetical within a folder. */
Status law_search_files(const LawSearch *search, LawFiles *files, Error *error);
void law_files_free(LawFiles *files);

#endif
