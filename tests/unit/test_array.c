/* Arrays are aligned and zeroed; sizes that cannot be had are errors; the n-th allocation can be made to
 * fail. */
#include "base/array.h"
#include "suite.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

START_TEST(arrays_are_zeroed_and_aligned_to_64_bytes) {
  Error error;
  for (size_t count = 0; count < 200; count += 7) {
    double *x = array_allocate(count, sizeof *x, "x", &error);
    ck_assert_ptr_nonnull(x);
    ck_assert_uint_eq((uintptr_t)x % 64, 0);
    for (size_t i = 0; i < count; i++) ck_assert(x[i] == 0.0);
    array_free(x);
  }
}
END_TEST

START_TEST(impossible_sizes_are_named_errors) {
  Error error;
  ck_assert_ptr_null(array_allocate(SIZE_MAX / 4, 8, "mesh", &error)); /* count * size would overflow */
  ck_assert_int_eq(error.code, STATUS_MEMORY);
  ck_assert_ptr_nonnull(strstr(error.text, "mesh"));
}
END_TEST

START_TEST(array_new_names_the_array_it_could_not_make) {
  Error error = {0};
  struct {
    double *nodes;
  } mesh = {NULL};
  ck_assert_int_eq(ARRAY_NEW(&mesh.nodes, 3, &error), STATUS_OK);
  array_free(mesh.nodes);
  array_fail_nth(1);
  ck_assert_int_eq(ARRAY_NEW(&mesh.nodes, 3, &error), STATUS_MEMORY);
  ck_assert_ptr_null(mesh.nodes);
  ck_assert_ptr_nonnull(strstr(error.text, "mesh.nodes"));
}
END_TEST

START_TEST(only_the_nth_allocation_fails) {
  Error error;
  for (long n = 1; n <= 4; n++) {
    array_fail_nth(n);
    for (long k = 1; k <= 5; k++) {
      void *array = array_allocate(1, 8, "array", &error);
      ck_assert_int_eq(array == NULL, k == n);
      array_free(array);
    }
  }
  ck_assert_int_eq(array_fail_nth(1), 0); /* all have failed */
  ck_assert_int_eq(array_fail_nth(0), 1); /* off again: one was left */
  void *array = array_allocate(1, 8, "array", &error);
  ck_assert_ptr_nonnull(array);
  array_free(array);
}
END_TEST

int main(void) {
  return suite_run("array",
                   (SuiteTests){arrays_are_zeroed_and_aligned_to_64_bytes, impossible_sizes_are_named_errors,
                                array_new_names_the_array_it_could_not_make, only_the_nth_allocation_fails,
                                NULL});
}
