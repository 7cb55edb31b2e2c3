/* Files go through HDF5's memory driver, so locks, paths and half-written files are nobody's concern here.
 * Objects carry no time stamps: equal content gives equal bytes. */
#include "observe/hdf.h"

#include "base/array.h"
#include <hdf5.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct Hdf {
  hid_t file;
  size_t front;
  size_t length;     /* of the image that was opened */
  H5E_auto2_t print; /* how HDF5 told of errors before, put back by hdf_free */
  void *print_data;
};

enum { MEMORY_INCREMENT = 1 << 20 };

/* The walk goes from the call of ours inward: the last entry is the cause. */
static herr_t keep_last(unsigned depth, const H5E_error2_t *entry, void *text) {
  (void)depth;
  snprintf(text, 256, "%s", entry->desc ? entry->desc : "no description");
  return 0;
}

static Status failed(Error *error, const char *what, const char *path) {
  char cause[256] = "no description";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_last, cause);
  return error_set(error, STATUS_IO, "HDF5 cannot %s %s: %s", what, path, cause);
}

static hid_t file_type(HdfType type) {
  return type == HDF_DOUBLE ? H5T_IEEE_F64LE : type == HDF_BYTE ? H5T_STD_U8LE : H5T_STD_I64LE;
}

static hid_t memory_type(HdfType type) {
  switch (type) {
  case HDF_DOUBLE:
    return H5T_NATIVE_DOUBLE;
  case HDF_INT:
    return H5T_NATIVE_INT;
  case HDF_BYTE:
    return H5T_NATIVE_UCHAR;
  default:
    return H5T_NATIVE_LLONG;
  }
}

/* An Hdf without a file, with HDF5 silenced, and the access list of a file in memory. */
static Status begin(Hdf **hdf, hid_t *access, Error *error) {
  *access = H5I_INVALID_HID;
  const Status status = ARRAY_NEW(hdf, 1, error);
  if (status != STATUS_OK) return status;
  (*hdf)->file = H5I_INVALID_HID;
  H5Eget_auto2(H5E_DEFAULT, &(*hdf)->print, &(*hdf)->print_data);
  H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
  *access = H5Pcreate(H5P_FILE_ACCESS);
  if (*access < 0 || H5Pset_fapl_core(*access, MEMORY_INCREMENT, 0) < 0)
    return failed(error, "use", "its memory driver");
  return STATUS_OK;
}

/* Ends hdf_new and hdf_open: on failure nothing is left. */
static Status finish(Hdf **hdf, hid_t access, Status status) {
  if (access >= 0) H5Pclose(access);
  if (status == STATUS_OK) return status;
  hdf_free(*hdf);
  *hdf = NULL;
  return status;
}

Status hdf_new(Hdf **hdf, size_t front, Error *error) {
  Status status;
  hid_t access, creation = H5I_INVALID_HID;
  TRY(begin(hdf, &access, error));
  (*hdf)->front = front;
  creation = H5Pcreate(H5P_FILE_CREATE);
  if (creation < 0 || H5Pset_userblock(creation, front) < 0)
    TRY(failed(error, "reserve the front of", "a file"));
  (*hdf)->file = H5Fcreate("memory", H5F_ACC_TRUNC, creation, access);
  if ((*hdf)->file < 0) TRY(failed(error, "make", "a file in memory"));
cleanup:
  if (creation >= 0) H5Pclose(creation);
  return finish(hdf, access, status);
}

Status hdf_open(Hdf **hdf, const char *image, size_t length, Error *error) {
  Status status;
  hid_t access;
  TRY(begin(hdf, &access, error));
  void *copied =
      (void *)(uintptr_t)image; /* HDF5 copies it, though it asks for a pointer that may be written */
  if (H5Pset_file_image(access, copied, length) < 0) TRY(failed(error, "take in", "a file image"));
  (*hdf)->length = length;
  (*hdf)->file = H5Fopen("memory", H5F_ACC_RDONLY, access);
  if ((*hdf)->file < 0) TRY(failed(error, "open", "a file image"));
cleanup:
  return finish(hdf, access, status);
}

void hdf_free(Hdf *hdf) {
  if (!hdf) return;
  if (hdf->file >= 0) H5Fclose(hdf->file);
  H5Eset_auto2(H5E_DEFAULT, hdf->print, hdf->print_data);
  array_free(hdf);
}

/* A dataset of the given type and shape, filled unless `values` is NULL. */
static Status write_dataset(Hdf *hdf, const char *path, hid_t stored, hid_t native, hid_t space,
                            const void *values, Error *error) {
  Status status = STATUS_OK;
  hid_t dataset = H5I_INVALID_HID;
  hid_t links = H5Pcreate(H5P_LINK_CREATE), creation = H5Pcreate(H5P_DATASET_CREATE);
  if (links < 0 || creation < 0 || space < 0 || H5Pset_create_intermediate_group(links, 1) < 0 ||
      H5Pset_obj_track_times(creation, 0) < 0)
    TRY(failed(error, "describe", path));
  dataset = H5Dcreate2(hdf->file, path, stored, space, links, creation, H5P_DEFAULT);
  if (dataset < 0) TRY(failed(error, "make", path));
  if (H5Dwrite(dataset, native, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0) TRY(failed(error, "write", path));
cleanup:
  if (dataset >= 0) H5Dclose(dataset);
  if (creation >= 0) H5Pclose(creation);
  if (links >= 0) H5Pclose(links);
  return status;
}

Status hdf_write(Hdf *hdf, const char *path, HdfType type, size_t rows, size_t columns, const void *values,
                 Error *error) {
  const hsize_t shape[2] = {rows, columns};
  hid_t space = H5Screate_simple(columns == 0 ? 1 : 2, shape, NULL);
  Status status = write_dataset(hdf, path, file_type(type), memory_type(type), space, values, error);
  if (space >= 0) H5Sclose(space);
  return status;
}

/* A fixed-length string type; the text is stored without its NUL, and an empty one as one NUL. */
static hid_t string_type(const char *text) {
  size_t length = strlen(text);
  hid_t type = H5Tcopy(H5T_C_S1);
  if (type >= 0 && (H5Tset_size(type, length ? length : 1) < 0 || H5Tset_strpad(type, H5T_STR_NULLPAD) < 0)) {
    H5Tclose(type);
    return H5I_INVALID_HID;
  }
  return type;
}

Status hdf_write_text(Hdf *hdf, const char *path, const char *text, Error *error) {
  hid_t space = H5Screate(H5S_SCALAR), type = string_type(text);
  Status status = write_dataset(hdf, path, type, type, space, text, error);
  if (type >= 0) H5Tclose(type);
  if (space >= 0) H5Sclose(space);
  return status;
}

Status hdf_link(Hdf *hdf, const char *path, const char *alias, Error *error) {
  if (H5Lcreate_hard(hdf->file, path, hdf->file, alias, H5P_DEFAULT, H5P_DEFAULT) < 0)
    return failed(error, "link", alias);
  return STATUS_OK;
}

static Status set_attribute(Hdf *hdf, const char *path, const char *name, hid_t stored, hid_t native,
                            hid_t space, const void *values, Error *error) {
  hid_t attribute =
      H5Acreate_by_name(hdf->file, path, name, stored, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  Status status = STATUS_OK;
  if (attribute < 0 || H5Awrite(attribute, native, values) < 0)
    status = failed(error, "set an attribute of", path);
  if (attribute >= 0) H5Aclose(attribute);
  return status;
}

Status hdf_set_integers(Hdf *hdf, const char *path, const char *name, const int *values, size_t count,
                        Error *error) {
  const hsize_t shape[1] = {count};
  hid_t space = H5Screate_simple(1, shape, NULL);
  Status status = set_attribute(hdf, path, name, H5T_STD_I64LE, H5T_NATIVE_INT, space, values, error);
  if (space >= 0) H5Sclose(space);
  return status;
}

Status hdf_set_text(Hdf *hdf, const char *path, const char *name, const char *text, Error *error) {
  hid_t space = H5Screate(H5S_SCALAR), type = string_type(text);
  Status status = set_attribute(hdf, path, name, type, type, space, text, error);
  if (type >= 0) H5Tclose(type);
  if (space >= 0) H5Sclose(space);
  return status;
}

Status hdf_image(Hdf *hdf, char **image, size_t *length, Error *error) {
  *image = NULL;
  if (H5Fflush(hdf->file, H5F_SCOPE_GLOBAL) < 0) return failed(error, "flush", "a file in memory");
  ssize_t data = H5Fget_file_image(hdf->file, NULL, 0); /* without the bytes in front */
  if (data <= 0) return failed(error, "give", "a file image");
  *length = hdf->front + (size_t)data;
  *image = array_allocate(*length, 1, "file image", error);
  if (!*image) return error->code;
  if (H5Fget_file_image(hdf->file, *image + hdf->front, (size_t)data) == data) return STATUS_OK;
  array_free(*image);
  *image = NULL;
  return failed(error, "give", "a file image");
}

bool hdf_exists(Hdf *hdf, const char *path) {
  return H5Lexists(hdf->file, path, H5P_DEFAULT) > 0;
}

static HdfType known_type(hid_t type) {
  H5T_class_t class = H5Tget_class(type);
  size_t size = H5Tget_size(type);
  if (class == H5T_FLOAT && size == sizeof(double)) return HDF_DOUBLE;
  if (class == H5T_INTEGER && size == sizeof(long long)) return HDF_LONG_LONG;
  return class == H5T_INTEGER && size == 1 ? HDF_BYTE : HDF_OTHER;
}

/* Refuses what a forged file says to hold beyond its own size. */
static Status check_size(const Hdf *hdf, const char *path, size_t count, size_t size, Error *error) {
  if (hdf->length == 0 || size == 0 || count <= hdf->length / size) return STATUS_OK;
  return error_set(error, STATUS_IO,
                   "%s: expected at most the %zu bytes of the file, found %zu values of %zu bytes", path,
                   hdf->length, count, size);
}

Status hdf_describe(Hdf *hdf, const char *path, HdfType *type, size_t *count, Error *error) {
  Status status = STATUS_OK;
  hid_t stored = H5I_INVALID_HID, space = H5I_INVALID_HID;
  hid_t dataset = H5Dopen2(hdf->file, path, H5P_DEFAULT);
  if (dataset < 0) TRY(failed(error, "open", path));
  stored = H5Dget_type(dataset);
  space = H5Dget_space(dataset);
  hssize_t points = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
  if (stored < 0 || points < 0) TRY(failed(error, "describe", path));
  TRY(check_size(hdf, path, (size_t)points, H5Tget_size(stored), error));
  *type = known_type(stored);
  *count = (size_t)points;
cleanup:
  if (space >= 0) H5Sclose(space);
  if (stored >= 0) H5Tclose(stored);
  if (dataset >= 0) H5Dclose(dataset);
  return status;
}

Status hdf_read(Hdf *hdf, const char *path, HdfType type, size_t count, void *values, Error *error) {
  HdfType stored;
  size_t found;
  Status status = hdf_describe(hdf, path, &stored, &found, error);
  if (status != STATUS_OK) return status;
  if (found != count)
    return error_set(error, STATUS_IO, "%s: expected %zu values, found %zu", path, count, found);
  hid_t dataset = H5Dopen2(hdf->file, path, H5P_DEFAULT);
  if (dataset < 0) return failed(error, "open", path);
  if (H5Dread(dataset, memory_type(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
    status = failed(error, "read", path);
  H5Dclose(dataset);
  return status;
}

Status hdf_read_text(Hdf *hdf, const char *path, Text *text, Error *error) {
  Status status = STATUS_OK;
  HdfType kind;
  size_t count;
  hid_t type = H5I_INVALID_HID;
  char *bytes = NULL;
  hid_t dataset = H5Dopen2(hdf->file, path, H5P_DEFAULT);
  if (dataset < 0) TRY(failed(error, "open", path));
  type = H5Dget_type(dataset);
  if (type < 0 || H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0)
    TRY(failed(error, "read as a text", path));
  TRY(hdf_describe(hdf, path, &kind, &count, error));
  if (count != 1) TRY(error_set(error, STATUS_IO, "%s: expected one text, found %zu", path, count));
  TRY(ARRAY_NEW(&bytes, H5Tget_size(type) + 1, error));
  if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes) < 0) TRY(failed(error, "read", path));
  TRY(text_append(text, error, "%s", bytes));
cleanup:
  array_free(bytes);
  if (type >= 0) H5Tclose(type);
  if (dataset >= 0) H5Dclose(dataset);
  return status;
}

Status hdf_count(Hdf *hdf, const char *path, size_t *count, Error *error) {
  H5G_info_t info;
  if (H5Gget_info_by_name(hdf->file, path, &info, H5P_DEFAULT) < 0) return failed(error, "open", path);
  *count = (size_t)info.nlinks;
  return STATUS_OK;
}

Status hdf_name(Hdf *hdf, const char *path, size_t index, Text *name, Error *error) {
  char buffer[256];
  if (H5Lget_name_by_idx(hdf->file, path, H5_INDEX_NAME, H5_ITER_INC, index, buffer, sizeof buffer,
                         H5P_DEFAULT) < 0)
    return failed(error, "list", path);
  return text_append(name, error, "%s", buffer);
}
