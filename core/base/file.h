/* Files and folders: read whole, write whole or not at all, hash, list. */
#ifndef CAPSELLA_BASE_FILE_H
#define CAPSELLA_BASE_FILE_H

#include "base/status.h"
#include "base/text.h"
#include <stdbool.h>
#include <stdint.h>

bool file_exists(const char *path); /* a regular file that can be read */

/* Reads a whole file (at most `limit` bytes, refused beyond) into `text`. */
Status file_read(const char *path, size_t limit, Text *text, Error *error);

/* Writes to a temporary name in the same folder, syncs, and renames: readers see the old file or the new one.
 */
Status file_write(const char *path, const char *data, size_t length, Error *error);

/* Renames a finished temporary file to its final name after syncing it (and its folder). */
Status file_publish(const char *temporary, const char *path, Error *error);

/* Makes a folder and its parents; an existing folder is fine, anything else in the way is an error. */
Status file_make_folder(const char *path, Error *error);

/* Removes a folder with all that it holds, as far as that can be removed. */
void file_remove_folder(const char *path);

/* 64-bit FNV-1a of a file's bytes: identifies a law's shared object in resolved.yaml and in snapshots. */
Status file_hash(const char *path, uint64_t *hash, Error *error);

/* "folder/name" (or name alone when it is absolute or folder is empty); of "./name" the dot is left out. */
Status file_join(Text *path, const char *folder, const char *name, Error *error);

/* The folder part of a path, "." when there is none. */
Status file_folder(Text *folder, const char *path, Error *error);

#endif
