/* HDF5 files in memory: named arrays, read and written whole.  The one room that includes hdf5.h.
 *
 * While an Hdf exists HDF5 prints nothing; what it has to say is in the Error (STATUS_IO). */
#ifndef CAPSELLA_OBSERVE_HDF_H
#define CAPSELLA_OBSERVE_HDF_H

#include "base/status.h"
#include "base/text.h"
#include <stdbool.h>
#include <stddef.h>

typedef struct Hdf Hdf;

typedef enum {
  HDF_DOUBLE,    /* double, 64 bits in the file */
  HDF_LONG_LONG, /* long long, 64 bits in the file */
  HDF_INT,       /* int; 64 bits in the file */
  HDF_BYTE,      /* unsigned char */
  HDF_OTHER      /* found in a file, not of these */
} HdfType;

/* An empty file whose data will stand behind `front` bytes for others to fill (0, or a power of two from
 * 512). */
Status hdf_new(Hdf **hdf, size_t front, Error *error);

/* The file in `image` (copied), read only; foreign bytes may stand in front of its data as above. */
Status hdf_open(Hdf **hdf, const char *image, size_t length, Error *error);
void hdf_free(Hdf *hdf);

/* `values` [rows][columns] (columns 0: a flat array [rows]) as the dataset `path`; groups on the way are
 * made. */
Status hdf_write(Hdf *hdf, const char *path, HdfType type, size_t rows, size_t columns, const void *values,
                 Error *error);
Status hdf_write_text(Hdf *hdf, const char *path, const char *text, Error *error);

/* A second name for a dataset. */
Status hdf_link(Hdf *hdf, const char *path, const char *alias, Error *error);

/* Attributes of an existing group. */
Status hdf_set_integers(Hdf *hdf, const char *path, const char *name, const int *values, size_t count,
                        Error *error);
Status hdf_set_text(Hdf *hdf, const char *path, const char *name, const char *text, Error *error);

/* The whole file: `image` is made by array_allocate, its first `front` bytes zero. */
Status hdf_image(Hdf *hdf, char **image, size_t *length, Error *error);

bool hdf_exists(Hdf *hdf, const char *path);

/* Type and number of values of a dataset, which are no more than the file has bytes for.  HDF_INT is not told
 * apart from HDF_LONG_LONG. */
Status hdf_describe(Hdf *hdf, const char *path, HdfType *type, size_t *count, Error *error);

/* All values of a dataset, which must be `count`, into `values`. */
Status hdf_read(Hdf *hdf, const char *path, HdfType type, size_t count, void *values, Error *error);
Status hdf_read_text(Hdf *hdf, const char *path, Text *text, Error *error);

/* Number of entries of a group, and the name of entry `index` in alphabetical order (appended). */
Status hdf_count(Hdf *hdf, const char *path, size_t *count, Error *error);
Status hdf_name(Hdf *hdf, const char *path, size_t index, Text *name, Error *error);

#endif
