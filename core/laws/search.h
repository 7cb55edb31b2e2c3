/* Where law plugins are looked for: an ordered list of folders, never searched recursively. */
#ifndef CAPSELLA_LAWS_SEARCH_H
#define CAPSELLA_LAWS_SEARCH_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>

/* Folders in the order they are searched; made by law_search_default. */
typedef struct {
  char **folder;
  size_t n;
  size_t n_foreign; /* the folders from here on belong to the program */
  /* Asked before a file that is not the program's is opened; NULL: none is asked.  On refusal (STATUS_INPUT)
   * the message is the reason, without the file's name. */
  Status (*admit)(const char *file, Error *error);
} LawSearch;

/* The scene's folder (may be NULL), then MLAW_PLUGIN_PATH (colon-separated), then those of the program or
 * shared library that this code is part of: `plugins` beside it (build tree), capsella/plugins below its
 * folder (an installed library), and the capsella/plugins of a library folder beside its own (an installed
 * program). Duplicates, empty entries and folders that do not exist are dropped. */
Status law_search_default(LawSearch *search, const char *scene_folder, Error *error);
void law_search_free(LawSearch *search);

/* Does the file, an absolute path without links, lie in a folder of the program? */
bool law_search_owns(const LawSearch *search, const char *file);

/* Plugin files: path, and name without folder and `.so`; made by law_search_files. */
typedef struct {
  char **path, **name;
  size_t n;
} LawFiles;

/* Every `*.so` of the folders, in search order and alphabetical within a folder. */
Status law_search_files(const LawSearch *search, LawFiles *files, Error *error);
void law_files_free(LawFiles *files);

#endif
