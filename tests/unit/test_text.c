/* Growable text and the nearest known name. */
#include "base/array.h"
#include "base/text.h"
#include "suite.h"
#include <stdlib.h>
#include <string.h>

START_TEST(text_grows_over_many_appends) {
  Error error;
  Text text = {0};
  for (int i = 0; i < 1000; i++) ck_assert_int_eq(text_append(&text, &error, "%04d;", i), STATUS_OK);
  ck_assert_uint_eq(text.length, 5000);
  ck_assert_uint_eq(strlen(text.data), 5000);
  for (int i = 0; i < 1000; i++) ck_assert_int_eq(atoi(text.data + 5 * i), i);
  text_free(&text);
  ck_assert_ptr_null(text.data);
}
END_TEST

START_TEST(every_length_around_a_doubling_ends_in_nul) {
  Error error;
  for (int n = 0; n < 300; n++) {
    Text text = {0};
    ck_assert_int_eq(text_append(&text, &error, "%*s", n, ""), STATUS_OK);
    ck_assert_uint_eq(text.length, n);
    ck_assert_int_eq(text.data[n], '\0');
    ck_assert_uint_lt(text.length, text.capacity);
    text_free(&text);
  }
}
END_TEST

START_TEST(bytes_are_kept_as_they_are) {
  Error error;
  Text text = {0};
  ck_assert_int_eq(text_append_bytes(&text, &error, "a\0b%", 4), STATUS_OK);
  ck_assert_int_eq(text_append_bytes(&text, &error, "c", 1), STATUS_OK);
  ck_assert_uint_eq(text.length, 5);
  ck_assert_mem_eq(text.data, "a\0b%c", 6);
  text_free(&text);
}
END_TEST

START_TEST(a_failed_append_leaves_the_text_as_it_was) {
  Error error;
  Text text = {0};
  ck_assert_int_eq(text_append(&text, &error, "kept"), STATUS_OK);
  array_fail_nth(1);
  ck_assert_int_eq(text_append(&text, &error, "%*s", 500, ""), STATUS_MEMORY);
  ck_assert_str_eq(text.data, "kept");
  text_free(&text);
}
END_TEST

START_TEST(copies_are_equal_and_apart) {
  Error error;
  const char *original = "membrane";
  char *copy = text_copy(original, &error);
  ck_assert_str_eq(copy, original);
  ck_assert_ptr_ne(copy, original);
  array_free(copy);
}
END_TEST

static const char *const NAMES[] = {"capillary_number", "gradient",   "kind", "path",
                                    "physical",         "remove_flux"};

static const char *nearest(const char *name) {
  return text_nearest(name, NAMES, sizeof NAMES / sizeof *NAMES);
}

START_TEST(slips_of_the_finger_find_the_name) {
  ck_assert_str_eq(nearest("kind"), "kind");
  ck_assert_str_eq(nearest("kidn"), "kind");                         /* swap of neighbours */
  ck_assert_str_eq(nearest("knd"), "kind");                          /* letter left out */
  ck_assert_str_eq(nearest("paths"), "path");                        /* letter too many */
  ck_assert_str_eq(nearest("gradiant"), "gradient");                 /* wrong letter */
  ck_assert_str_eq(nearest("Capillary-Number"), "capillary_number"); /* case and separator */
}
END_TEST

START_TEST(names_with_nothing_in_common_find_nothing) {
  ck_assert_ptr_null(nearest("viscosity"));
  ck_assert_ptr_null(nearest("x"));
  ck_assert_ptr_null(nearest(""));
  ck_assert_ptr_null(text_nearest("kind", NULL, 0));
}
END_TEST

START_TEST(very_long_names_are_not_compared) {
  char name[1000];
  memset(name, 'k', sizeof name - 1);
  name[sizeof name - 1] = '\0';
  ck_assert_ptr_null(nearest(name));
}
END_TEST

START_TEST(a_text_beyond_all_memory_is_refused_before_it_is_read) {
  Text text = {0};
  Error error;
  ck_assert_int_eq(text_append_bytes(&text, &error, "a", SIZE_MAX / 2 + 2), STATUS_MEMORY);
  ck_assert_ptr_nonnull(strstr(error.text, "text: "));
  text_free(&text);
}
END_TEST

int main(void) {
  return suite_run("text",
                   (SuiteTests){text_grows_over_many_appends, every_length_around_a_doubling_ends_in_nul,
                                bytes_are_kept_as_they_are, a_failed_append_leaves_the_text_as_it_was,
                                copies_are_equal_and_apart, slips_of_the_finger_find_the_name,
                                names_with_nothing_in_common_find_nothing, very_long_names_are_not_compared,
                                a_text_beyond_all_memory_is_refused_before_it_is_read, NULL});
}
