/* Arrays, texts and names through an HDF5 file in memory. */
#include "observe/hdf.h"

#include "base/array.h"
#include "suite.h"
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { FRONT = 512 };
static const double numbers[6] = {1.0 / 3, -0.0, 5e-324, HUGE_VAL, NAN, 1e300};
static const long long integers[3] = {LLONG_MIN, 0, LLONG_MAX};
static const int small[4] = {1, -2, INT_MAX, INT_MIN};

static void write_all(char **image, size_t *length) {
  Error error;
  Hdf *hdf;
  ck_assert_int_eq(hdf_new(&hdf, FRONT, &error), STATUS_OK);
  ck_assert_int_eq(hdf_write(hdf, "/a/numbers", HDF_DOUBLE, 3, 2, numbers, &error), STATUS_OK);
  ck_assert_int_eq(hdf_write(hdf, "/a/integers", HDF_LONG_LONG, 3, 0, integers, &error), STATUS_OK);
  ck_assert_int_eq(hdf_write(hdf, "/a/small", HDF_INT, 4, 0, small, &error), STATUS_OK);
  ck_assert_int_eq(hdf_write(hdf, "/a/none", HDF_DOUBLE, 0, 0, numbers, &error), STATUS_OK);
  ck_assert_int_eq(hdf_write(hdf, "/a/bytes", HDF_BYTE, 5, 0, "bytes", &error), STATUS_OK);
  ck_assert_int_eq(hdf_write_text(hdf, "/text", "caf\xc3\xa9\nline", &error), STATUS_OK);
  ck_assert_int_eq(hdf_write_text(hdf, "/empty", "", &error), STATUS_OK);
  ck_assert_int_eq(hdf_set_integers(hdf, "/a", "Version", small, 2, &error), STATUS_OK);
  ck_assert_int_eq(hdf_set_text(hdf, "/a", "Type", "Grid", &error), STATUS_OK);
  ck_assert_int_eq(hdf_link(hdf, "/a/numbers", "/a/alias", &error), STATUS_OK);
  ck_assert_int_eq(hdf_image(hdf, image, length, &error), STATUS_OK);
  hdf_free(hdf);
}

static Hdf *reopened(void) {
  Error error;
  Hdf *hdf;
  char *image;
  size_t length;
  write_all(&image, &length);
  memset(image, 'x', FRONT); /* whatever stands in front */
  ck_assert_int_eq(hdf_open(&hdf, image, length, &error), STATUS_OK);
  array_free(image);
  return hdf;
}

START_TEST(arrays_come_back_bit_for_bit) {
  Error error;
  Hdf *hdf = reopened();
  double read[6];
  long long whole[4];
  ck_assert_int_eq(hdf_read(hdf, "/a/numbers", HDF_DOUBLE, 6, read, &error), STATUS_OK);
  ck_assert_mem_eq(read, numbers, sizeof read);
  ck_assert_int_eq(hdf_read(hdf, "/a/alias", HDF_DOUBLE, 6, read, &error), STATUS_OK);
  ck_assert_mem_eq(read, numbers, sizeof read);
  ck_assert_int_eq(hdf_read(hdf, "/a/integers", HDF_LONG_LONG, 3, whole, &error), STATUS_OK);
  ck_assert_mem_eq(whole, integers, sizeof integers);
  ck_assert_int_eq(hdf_read(hdf, "/a/small", HDF_LONG_LONG, 4, whole, &error), STATUS_OK);
  for (int k = 0; k < 4; k++) ck_assert_int_eq(whole[k], small[k]);
  hdf_free(hdf);
}
END_TEST

START_TEST(texts_come_back_whole) {
  Error error;
  Hdf *hdf = reopened();
  Text text = {0}, empty = {0};
  ck_assert_int_eq(hdf_read_text(hdf, "/text", &text, &error), STATUS_OK);
  ck_assert_str_eq(text.data, "caf\xc3\xa9\nline");
  ck_assert_int_eq(hdf_read_text(hdf, "/empty", &empty, &error), STATUS_OK);
  ck_assert_str_eq(empty.data, "");
  ck_assert_int_eq(hdf_read_text(hdf, "/a/numbers", &text, &error), STATUS_IO);
  text_free(&text);
  text_free(&empty);
  hdf_free(hdf);
}
END_TEST

START_TEST(type_and_count_are_told) {
  const struct {
    const char *path;
    HdfType type;
    size_t count;
  } known[] = {{"/a/numbers", HDF_DOUBLE, 6},  {"/a/integers", HDF_LONG_LONG, 3}, {"/a/none", HDF_DOUBLE, 0},
               {"/a/small", HDF_LONG_LONG, 4}, {"/a/bytes", HDF_BYTE, 5},         {"/text", HDF_OTHER, 1}};
  Error error;
  Hdf *hdf = reopened();
  for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
    HdfType type;
    size_t count;
    ck_assert_int_eq(hdf_describe(hdf, known[k].path, &type, &count, &error), STATUS_OK);
    ck_assert_int_eq(type, known[k].type);
    ck_assert_uint_eq(count, known[k].count);
  }
  hdf_free(hdf);
}
END_TEST

START_TEST(a_group_lists_its_names_in_alphabetical_order) {
  const char *const expected[] = {"alias", "bytes", "integers", "none", "numbers", "small"};
  Error error;
  Hdf *hdf = reopened();
  size_t count;
  ck_assert_int_eq(hdf_count(hdf, "/a", &count, &error), STATUS_OK);
  ck_assert_uint_eq(count, 6);
  for (size_t k = 0; k < count; k++) {
    Text name = {0};
    ck_assert_int_eq(hdf_name(hdf, "/a", k, &name, &error), STATUS_OK);
    ck_assert_str_eq(name.data, expected[k]);
    text_free(&name);
  }
  ck_assert(hdf_exists(hdf, "/a/none"));
  ck_assert(!hdf_exists(hdf, "/a/nothing"));
  ck_assert(!hdf_exists(hdf, "/b/nothing"));
  hdf_free(hdf);
}
END_TEST

START_TEST(equal_content_gives_equal_bytes) {
  char *first, *second;
  size_t first_length, second_length;
  write_all(&first, &first_length);
  write_all(&second, &second_length);
  ck_assert_uint_eq(first_length, second_length);
  ck_assert_mem_eq(first, second, first_length);
  for (int k = 0; k < FRONT; k++) ck_assert_int_eq(first[k], 0);
  array_free(first);
  array_free(second);
}
END_TEST

START_TEST(failures_are_named_and_give_the_reason_of_hdf5) {
  Error error;
  Hdf *hdf;
  double value;
  ck_assert_int_eq(hdf_open(&hdf, "no such thing", 13, &error), STATUS_IO);
  ck_assert_ptr_null(hdf);
  ck_assert_ptr_nonnull(strstr(error.text, "signature"));
  hdf = reopened();
  ck_assert_int_eq(hdf_read(hdf, "/a/nothing", HDF_DOUBLE, 1, &value, &error), STATUS_IO);
  ck_assert_str_eq(error.text, "HDF5 cannot open /a/nothing: object 'nothing' doesn't exist");
  ck_assert_int_eq(hdf_read(hdf, "/a/numbers", HDF_DOUBLE, 1, &value, &error), STATUS_IO); /* it holds six */
  ck_assert_str_eq(error.text, "/a/numbers: expected 1 values, found 6");
  ck_assert_int_eq(hdf_write(hdf, "/b", HDF_DOUBLE, 1, 0, numbers, &error), STATUS_IO); /* read only */
  hdf_free(hdf);
  hdf_free(NULL);
}
END_TEST

/* A file that holds `count` doubles in /scene, with `size` bytes of it changed in as many places as they are
 * found. */
static Hdf *forged(size_t count, const char *from, const char *to, size_t size, int *changes) {
  Error error;
  Hdf *hdf;
  char *image;
  size_t length;
  double *values = calloc(count, sizeof *values);
  ck_assert_ptr_nonnull(values);
  ck_assert_int_eq(hdf_new(&hdf, FRONT, &error), STATUS_OK);
  ck_assert_int_eq(hdf_write(hdf, "/scene", HDF_DOUBLE, count, 0, values, &error), STATUS_OK);
  free(values);
  ck_assert_int_eq(hdf_image(hdf, &image, &length, &error), STATUS_OK);
  hdf_free(hdf);
  *changes = 0;
  for (size_t k = 0; k + size <= length; k++) {
    if (memcmp(image + k, from, size) != 0) continue;
    memcpy(image + k, to, size);
    ++*changes;
  }
  ck_assert_int_eq(hdf_open(&hdf, image, length, &error), STATUS_OK);
  array_free(image);
  return hdf;
}

/* The class of the stored type of doubles is changed to that of texts: two of eight bytes. */
START_TEST(more_than_one_text_is_refused) {
  static const char doubles[8] = "\x11\x20\x3f\0\x08\0\0\0", texts[8] = "\x13\0\0\0\x08\0\0\0";
  Error error;
  int changes;
  Text text = {0};
  Hdf *hdf = forged(2, doubles, texts, sizeof doubles, &changes);
  ck_assert_int_eq(changes, 1);
  ck_assert_int_eq(hdf_read_text(hdf, "/scene", &text, &error), STATUS_IO);
  ck_assert_str_eq(error.text, "/scene: expected one text, found 2");
  text_free(&text);
  hdf_free(hdf);
}
END_TEST

/* The extent of an array, and what it may grow to, is changed from 291 to 2^32 + 291. */
START_TEST(an_array_larger_than_its_file_is_refused_before_memory_is_asked_for) {
  static const char extent[8] = "\x23\x01\0\0\0\0\0\0", larger[8] = "\x23\x01\0\0\x01\0\0\0";
  Error error = {.text = "nothing"};
  HdfType type;
  size_t count;
  int changes;
  Hdf *hdf = forged(291, extent, larger, sizeof extent, &changes);
  ck_assert_int_eq(changes, 2);
  ck_assert_int_eq(hdf_describe(hdf, "/scene", &type, &count, &error), STATUS_IO);
  ck_assert_msg(strstr(error.text, "bytes of the file, found 4294967587 values of 8 bytes"), "%s",
                error.text);
  hdf_free(hdf);
}
END_TEST

int main(void) {
  return suite_run(
      "hdf", (SuiteTests){arrays_come_back_bit_for_bit, texts_come_back_whole, type_and_count_are_told,
                          a_group_lists_its_names_in_alphabetical_order, equal_content_gives_equal_bytes,
                          failures_are_named_and_give_the_reason_of_hdf5, more_than_one_text_is_refused,
                          an_array_larger_than_its_file_is_refused_before_memory_is_asked_for, NULL});
}
