/* The seal of a snapshot: whatever is changed or cut off, it does not fit any more. */
#include "observe/seal.h"

#include "suite.h"
#include <string.h>

static const char DATA[] = "foobar";
enum { FILE_SIZE = SEAL_SIZE + sizeof DATA - 1 };

static void make_file(char file[FILE_SIZE]) {
  memcpy(file + SEAL_SIZE, DATA, sizeof DATA - 1);
  seal_make(DATA, sizeof DATA - 1, file);
}

START_TEST(the_checksum_is_that_of_the_published_table) {
  char file[FILE_SIZE];
  make_file(file);
  ck_assert_ptr_nonnull(strstr(file, "FNV-1a checksum: 85944171f73967e8\n")); /* "foobar", 64 bits */
}
END_TEST

START_TEST(a_sealed_file_passes) {
  Error error;
  char file[FILE_SIZE], empty[SEAL_SIZE];
  make_file(file);
  ck_assert_int_eq(seal_check(file, FILE_SIZE, &error), STATUS_OK);
  seal_make("", 0, empty);
  ck_assert_int_eq(seal_check(empty, SEAL_SIZE, &error), STATUS_OK);
}
END_TEST

START_TEST(every_single_changed_bit_is_found) {
  Error error;
  char file[FILE_SIZE];
  make_file(file);
  for (int bit = 0; bit < 8 * FILE_SIZE; bit++) {
    const char mask = (char)(1U << bit % 8);
    file[bit / 8] ^= mask;
    ck_assert_msg(seal_check(file, FILE_SIZE, &error) == STATUS_IO, "bit %d", bit);
    file[bit / 8] ^= mask;
  }
}
END_TEST

START_TEST(every_other_length_is_found) {
  Error error;
  char file[FILE_SIZE + 1] = {0};
  make_file(file);
  for (size_t length = 0; length <= FILE_SIZE + 1; length++)
    if (length != FILE_SIZE) ck_assert_int_eq(seal_check(file, length, &error), STATUS_IO);
}
END_TEST

START_TEST(the_message_tells_the_three_cases_apart) {
  Error error;
  char file[FILE_SIZE];
  make_file(file);
  ck_assert_int_eq(seal_check(file, FILE_SIZE - 1, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "cut off: expected 518 bytes, found 517; resume from an older"));
  file[SEAL_SIZE] = 'g';
  ck_assert_int_eq(seal_check(file, FILE_SIZE, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "was altered"));
  *strstr(file, "format 1") = 'F';
  ck_assert_int_eq(seal_check(file, FILE_SIZE, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "not a snapshot"));
  make_file(file);
  strstr(file, "format 1")[7] = '2';
  ck_assert_int_eq(seal_check(file, FILE_SIZE, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "format 2, this program reads format 1; use the version"));
}
END_TEST

int main(void) {
  return suite_run("seal", (SuiteTests){the_checksum_is_that_of_the_published_table, a_sealed_file_passes,
                                        every_single_changed_bit_is_found, every_other_length_is_found,
                                        the_message_tells_the_three_cases_apart, NULL});
}
