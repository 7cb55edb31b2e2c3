/* Files and folders through POSIX.  A file that others may read while it is written goes through a temporary
 * name; nothing here interprets content. */
#include "base/file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static Status failed(Error *error, const char *what, const char *path) {
  return error_set(error, STATUS_IO, "%s: cannot %s: %s", path, what, strerror(errno));
}

bool file_exists(const char *path) {
  struct stat info;
  return stat(path, &info) == 0 && S_ISREG(info.st_mode) && access(path, R_OK) == 0;
}

Status file_read(const char *path, size_t limit, Text *text, Error *error) {
  FILE *file = fopen(path, "rb");
  if (!file) return failed(error, "be read", path);
  Status status = STATUS_OK;
  char block[4096];
  size_t count, total = 0;
  TRY(text_append_bytes(text, error, "", 0)); /* an empty file gives an empty string, not NULL */
  while ((count = fread(block, 1, sizeof block, file)) > 0) {
    total += count;
    if (total > limit) {
      TRY(error_set(error, STATUS_IO, "%s: expected at most %zu bytes, found more", path, limit));
    }
    TRY(text_append_bytes(text, error, block, count));
  }
  if (ferror(file)) TRY(failed(error, "be read", path));
cleanup:
  fclose(file);
  return status;
}

static Status sync_path(const char *path, int flags, Error *error) {
  int handle = open(path, flags);
  if (handle < 0) return failed(error, "be opened", path);
  /* Some file systems cannot sync a folder and say EINVAL: then the rename is all that can be had. */
  Status status = fsync(handle) != 0 && errno != EINVAL ? failed(error, "be synced", path) : STATUS_OK;
  close(handle);
  return status;
}

Status file_publish(const char *temporary, const char *path, Error *error) {
  Status status;
  Text folder = {0};
  TRY(file_folder(&folder, path, error));
  TRY(sync_path(temporary, O_RDONLY, error));
  if (rename(temporary, path) != 0) TRY(failed(error, "be replaced", path));
  TRY(sync_path(folder.data, O_RDONLY | O_DIRECTORY, error));
cleanup:
  text_free(&folder);
  return status;
}

Status file_write(const char *path, const char *data, size_t length, Error *error) {
  Status status;
  Text temporary = {0};
  FILE *file = NULL;
  TRY(text_append(&temporary, error, "%s.part", path));
  file = fopen(temporary.data, "wb");
  if (!file) TRY(failed(error, "be written", path));
  size_t written = fwrite(data, 1, length, file);
  int closed = fclose(file);
  if (written != length || closed != 0) TRY(failed(error, "be written", path));
  TRY(file_publish(temporary.data, path, error));
cleanup:
  if (status != STATUS_OK && file) remove(temporary.data);
  text_free(&temporary);
  return status;
}

static Status make_one_folder(const char *path, Error *error) {
  struct stat info;
  if (mkdir(path, 0777) == 0) return STATUS_OK;
  int reason = errno; /* an existing folder may also answer EROFS or EACCES */
  if (stat(path, &info) == 0 && S_ISDIR(info.st_mode)) return STATUS_OK;
  errno = reason;
  return failed(error, "be made a folder", path);
}

Status file_make_folder(const char *path, Error *error) {
  Status status;
  Text part = {0};
  TRY(text_append(&part, error, "%s", path));
  for (size_t i = 1; i < part.length; i++) {
    if (part.data[i] != '/') continue;
    part.data[i] = '\0';
    TRY(make_one_folder(part.data, error));
    part.data[i] = '/';
  }
  TRY(make_one_folder(part.data, error));
cleanup:
  text_free(&part);
  return status;
}

/* What a link points to is left alone. */
void file_remove_folder(const char *path) {
  struct stat info;
  DIR *entries = lstat(path, &info) == 0 && S_ISDIR(info.st_mode) ? opendir(path) : NULL;
  for (struct dirent *entry; entries && (entry = readdir(entries));) {
    if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
    Error error;
    Text inner = {0};
    if (file_join(&inner, path, entry->d_name, &error) == STATUS_OK) file_remove_folder(inner.data);
    text_free(&inner);
  }
  if (entries) closedir(entries);
  remove(path);
}

Status file_hash(const char *path, uint64_t *hash, Error *error) {
  FILE *file = fopen(path, "rb");
  if (!file) return failed(error, "be read", path);
  unsigned char block[4096];
  size_t count;
  uint64_t h = UINT64_C(0xcbf29ce484222325);
  while ((count = fread(block, 1, sizeof block, file)) > 0)
    for (size_t i = 0; i < count; i++) h = (h ^ block[i]) * UINT64_C(0x100000001b3);
  Status status = ferror(file) ? failed(error, "be read", path) : STATUS_OK;
  fclose(file);
  *hash = h;
  return status;
}

Status file_join(Text *path, const char *folder, const char *name, Error *error) {
  if (*name == '/' || *folder == '\0') return text_append(path, error, "%s", name);
  const char *slash = folder[strlen(folder) - 1] == '/' ? "" : "/";
  if (strncmp(name, "./", 2) == 0) name += 2;
  return text_append(path, error, "%s%s%s", folder, slash, name);
}

Status file_folder(Text *folder, const char *path, Error *error) {
  const char *slash = strrchr(path, '/');
  if (!slash) return text_append(folder, error, ".");
  if (slash == path) return text_append(folder, error, "/");
  return text_append_bytes(folder, error, path, (size_t)(slash - path));
}
