/* Labels are readable, safe as names of folders, and different for different settings. */
#include "study/label.h"
#include "suite.h"
#include <string.h>

static void make(Text *label, const Override *settings, size_t n) {
  Error error;
  ck_assert_int_eq(label_append(label, settings, n, &error), STATUS_OK);
}

START_TEST(a_label_names_what_is_set) {
  const Override settings[] = {{.key = "flow.capillary_number", .value = "0.7"},
                               {.key = "membrane.damage.parameters.Y_D", .value = "2e-1"}};
  Text label = {0};
  make(&label, settings, 2);
  ck_assert_str_eq(label.data, "capillary_number=0.7,Y_D=2e-1");
  text_free(&label);
  make(&label, settings, 0);
  ck_assert_str_eq(label.data, "base");
  text_free(&label);
}
END_TEST

START_TEST(settings_that_look_alike_get_different_labels) {
  const Override alike[][2] = {
      {{.key = "membrane.law", .value = "./a/b.so"}, {.key = "membrane.damage.law", .value = "x"}},
      {{.key = "membrane.law", .value = "./a_b.so"}, {.key = "membrane.damage.law", .value = "x"}},
      {{.key = "membrane.damage.law", .value = "./a_b.so"}, {.key = "membrane.law", .value = "x"}},
      {{.key = "membrane.law", .value = "./a b.so"}, {.key = "membrane.damage.law", .value = "x"}}};
  Text label[4] = {{0}};
  for (int i = 0; i < 4; i++) {
    make(&label[i], alike[i], 2);
    ck_assert_ptr_null(strpbrk(label[i].data, "/ \n"));
    for (int j = 0; j < i; j++) ck_assert_str_ne(label[i].data, label[j].data);
  }
  for (int i = 0; i < 4; i++) text_free(&label[i]);
}
END_TEST

START_TEST(a_long_value_is_cut_and_told_apart_by_its_hash) {
  char first[400], second[400];
  memset(first, 'a', sizeof first);
  first[399] = '\0';
  memcpy(second, first, sizeof first);
  second[398] = 'b';
  Text a = {0}, b = {0};
  make(&a, &(Override){.key = "name", .value = first}, 1);
  make(&b, &(Override){.key = "name", .value = second}, 1);
  ck_assert_uint_lt(a.length, 200);
  ck_assert_str_ne(a.data, b.data);
  text_free(&a);
  text_free(&b);
}
END_TEST

START_TEST(the_hash_is_that_of_the_definition) {
  /* 64-bit FNV-1a, from the table of its authors. */
  ck_assert(label_hash(LABEL_HASH_START, "") == UINT64_C(0xcbf29ce484222325));
  ck_assert(label_hash(LABEL_HASH_START, "a") == UINT64_C(0xaf63dc4c8601ec8c));
  ck_assert(label_hash(LABEL_HASH_START, "foobar") == UINT64_C(0x85944171f73967e8));
}
END_TEST

int main(void) {
  return suite_run("label",
                   (SuiteTests){a_label_names_what_is_set, settings_that_look_alike_get_different_labels,
                                a_long_value_is_cut_and_told_apart_by_its_hash,
                                the_hash_is_that_of_the_definition, NULL});
}
