/* Packed numbers, unpacked here from their definition. */
#include "observe/packed.h"

#include "suite.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static Text text;
static Error error;
static Json json;

static const char *packed(const double *values, size_t count) {
  text_free(&text);
  json_begin(&json, &text, &error);
  ck_assert_int_eq(packed_numbers(&json, NULL, values, count), STATUS_OK);
  ck_assert_int_eq(json_end(&json), STATUS_OK);
  return text.data;
}

/* The number behind "key": in the packed text. */
static double bound(const char *key) {
  const char *at = strstr(text.data, key);
  ck_assert_ptr_nonnull(at);
  return strtod(strchr(at, ':') + 1, NULL);
}

static unsigned digit(char c) {
  const char *const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const char *at = strchr(digits, c);
  ck_assert(c != '\0' && at);
  return (unsigned)(at - digits);
}

/* Byte k of the base64 that begins at `base64`: 8 bits from bit 8 k on. */
static unsigned byte_at(const char *base64, size_t k) {
  const size_t first = 8 * k / 6, shift = 8 * k % 6;
  const unsigned twelve = digit(base64[first]) << 6 | digit(base64[first + 1]);
  return twelve >> (4 - shift) & 0xff;
}

static unsigned level(size_t k) {
  const char *data = strstr(text.data, "\"data\": \"");
  ck_assert_ptr_nonnull(data);
  data += strlen("\"data\": \"");
  return byte_at(data, 2 * k) | byte_at(data, 2 * k + 1) << 8;
}

START_TEST(every_value_comes_back_to_half_a_level) {
  enum { N = 1001 };
  double values[N];
  for (int k = 0; k < N; k++) values[k] = 3 * sin(0.1 * k) - 1;
  packed(values, N);
  const double min = bound("\"min\""), max = bound("\"max\""), step = (max - min) / PACKED_LEVELS;
  for (size_t k = 0; k < N; k++) /* half a level, and the round-off of the division */
    ck_assert_double_eq_tol(min + step * level(k), values[k], 0.5 * step * (1 + 1e-9));
}
END_TEST

START_TEST(bounds_are_exact) {
  packed((const double[]){0.1, -2.5, 1.0 / 3}, 3);
  ck_assert(bound("\"min\"") == -2.5 && bound("\"max\"") == 1.0 / 3);
  ck_assert_uint_eq(level(1), 0);
  ck_assert_uint_eq(level(2), PACKED_LEVELS);
}
END_TEST

START_TEST(what_is_no_number_is_marked_and_spoils_no_bounds) {
  packed((const double[]){NAN, 1, INFINITY, 2, -INFINITY}, 5);
  ck_assert(bound("\"min\"") == 1 && bound("\"max\"") == 2);
  for (size_t k = 0; k < 5; k += 2) ck_assert_uint_eq(level(k), PACKED_NAN);
  packed((const double[]){NAN}, 1);
  ck_assert(bound("\"min\"") == 0 && bound("\"max\"") == 0);
}
END_TEST

START_TEST(equal_values_are_the_lower_bound) {
  packed((const double[]){7, 7}, 2);
  ck_assert_uint_eq(level(0) + level(1), 0);
  ck_assert(bound("\"min\"") == 7);
}
END_TEST

START_TEST(integers_are_four_bytes_each_lowest_first) {
  text_free(&text);
  json_begin(&json, &text, &error);
  ck_assert_int_eq(packed_integers(&json, NULL, (const int[]){1, 258, -1}, 3), STATUS_OK);
  ck_assert_int_eq(json_end(&json), STATUS_OK);
  ck_assert_str_eq(text.data, "\"AQAAAAIBAAD/////\"\n");
}
END_TEST

int main(void) {
  return suite_run("packed", (SuiteTests){every_value_comes_back_to_half_a_level, bounds_are_exact,
                                          what_is_no_number_is_marked_and_spoils_no_bounds,
                                          equal_values_are_the_lower_bound,
                                          integers_are_four_bytes_each_lowest_first, NULL});
}
