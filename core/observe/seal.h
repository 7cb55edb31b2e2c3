/* The seal of a snapshot: 512 bytes of text in front of its data that tell format, length and checksum.
 *
 * It is an HDF5 user block, which every HDF5 reader skips.  Checked before the data are parsed, it keeps a
 * cut-off or altered file away from the parser; it is no protection against intent. */
#ifndef CAPSELLA_OBSERVE_SEAL_H
#define CAPSELLA_OBSERVE_SEAL_H

#include "base/status.h"
#include <stddef.h>

enum { SEAL_SIZE = 512, SEAL_FORMAT = 1 };

/* The seal of `length` bytes of data. */
void seal_make(const void *data, size_t length, char seal[SEAL_SIZE]);

/* Whether `file` (seal and data, `length` bytes in all) is what was sealed: STATUS_IO with the reason and
 * what to do otherwise.  One changed byte is always found. */
Status seal_check(const char *file, size_t length, Error *error);

#endif
