/* Checksum: 64-bit FNV-1a.  Each byte enters through two bijections of the state, so no change of a single
 * byte goes unseen. */
#include "observe/seal.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static uint64_t checksum(const unsigned char *data, size_t length) {
  uint64_t hash = UINT64_C(0xcbf29ce484222325);
  for (size_t k = 0; k < length; k++) hash = (hash ^ data[k]) * UINT64_C(0x100000001b3);
  return hash;
}

void seal_make(const void *data, size_t length, char seal[SEAL_SIZE]) {
  memset(seal, 0, SEAL_SIZE);
  snprintf(seal, SEAL_SIZE,
           "Capsella snapshot, format %d\n"
           "bytes after this block: %zu\n"
           "their FNV-1a checksum: %016" PRIx64 "\n"
           "An HDF5 file follows: /VTKHDF is for ParaView, /restart for capsella run --resume.\n",
           SEAL_FORMAT, length, checksum(data, length));
}

Status seal_check(const char *file, size_t length, Error *error) {
  static const char advice[] = "resume from an older snapshot, or start anew";
  int format = 0;
  size_t sealed = 0;
  char start[SEAL_SIZE + 1] = {0};
  memcpy(start, file, length < SEAL_SIZE ? length : SEAL_SIZE);
  int fields =
      sscanf(start, "Capsella snapshot, format %6d\nbytes after this block: %15zu\n", &format, &sealed);
  if (fields < 1)
    return error_set(error, STATUS_IO, "not a snapshot of Capsella, or cut off at its start (%zu bytes); %s",
                     length, advice);
  if (format != SEAL_FORMAT)
    return error_set(error, STATUS_IO,
                     "a snapshot of format %d, this program reads format %d; use the version of the program "
                     "that wrote it, or start anew",
                     format, SEAL_FORMAT);
  if (length < SEAL_SIZE || sealed != length - SEAL_SIZE)
    return error_set(error, STATUS_IO, "the snapshot is cut off: expected %zu bytes, found %zu; %s",
                     sealed + SEAL_SIZE, length, advice);
  char expected[SEAL_SIZE];
  seal_make(file + SEAL_SIZE, sealed, expected);
  if (memcmp(file, expected, SEAL_SIZE) != 0)
    return error_set(error, STATUS_IO, "the snapshot was altered: its checksum does not match; %s", advice);
  return STATUS_OK;
}
