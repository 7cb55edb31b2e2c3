/* Quantities: the values of physical units (checked against the definitions of the SI), what is refused, and
 * that printed quantities read back bit for bit. */
#include "config/units.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static Quantity parse_good(const char *text) {
  Quantity quantity;
  Error error;
  Status status = units_parse(text, &quantity, &error);
  ck_assert_msg(status == STATUS_OK, "%s: %s", text, error.text);
  return quantity;
}

START_TEST(bare_numbers_are_kept_as_written) {
  static const struct {
    const char *text;
    double value;
  } table[] = {{"0", 0},     {"-0.5", -0.5}, {".5", 0.5},     {"5.", 5},     {"+3", 3},
               {"1e3", 1e3}, {"1E-3", 1e-3}, {"2.5e+2", 250}, {"007.5", 7.5}};
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    Quantity q = parse_good(table[i].text);
    ck_assert(q.value == table[i].value && !q.has_unit);
  }
}
END_TEST

START_TEST(units_have_the_values_and_dimensions_of_the_si) {
  static const struct {
    const char *text;
    double value;
    signed char dim[3];
  } table[] = {
      {"0.05 N/m", 0.05, {1, 0, -2}},
      {"35 um", 35e-6, {0, 1, 0}},
      {"35 \xc2\xb5m", 35e-6, {0, 1, 0}}, /* U+00B5, micro sign */
      {"35 \xce\xbcm", 35e-6, {0, 1, 0}}, /* U+03BC, Greek mu */
      {"1 mPa.s", 1e-3, {1, -1, -1}},
      {"1 mPa*s", 1e-3, {1, -1, -1}},
      {"1 mPa s", 1e-3, {1, -1, -1}},
      {"20 1/s", 20, {0, 0, -1}},
      {"20 /s", 20, {0, 0, -1}},
      {"20/s", 20, {0, 0, -1}},
      {"20 s^-1", 20, {0, 0, -1}},
      {"20 Hz", 20, {0, 0, -1}},
      {"3 mN/m", 3e-3, {1, 0, -2}},
      {"3 dyn/cm", 3e-3, {1, 0, -2}}, /* 1e-5 N / 1e-2 m */
      {"1 cP", 1e-3, {1, -1, -1}},    /* a centipoise is a millipascal second */
      {"2 kg.m^-1.s^-1", 2, {1, -1, -1}},
      {"2 kg/m/s", 2, {1, -1, -1}},
      {"7 uJ/m^2", 7e-6, {1, 0, -2}},
      {"1 kPa", 1e3, {1, -1, -2}},
      {"2 mbar", 200, {1, -1, -2}},
      {"1 Pa", 1, {1, -1, -2}}, /* not a peta-something */
      {"4 ms", 4e-3, {0, 0, 1}},
      {"4 m.s", 4, {0, 1, 1}},
      {"5 mm^2", 5e-6, {0, 2, 0}}, /* the power applies to the prefix as well */
      {"5g", 5e-3, {1, 0, 0}},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    Quantity q = parse_good(table[i].text);
    ck_assert_msg(q.value == table[i].value, "%s: %.17g", table[i].text, q.value);
    ck_assert(q.has_unit);
    ck_assert_mem_eq(q.dim, table[i].dim, 3);
    ck_assert_int_eq(q.dim[3], 0);
  }
}
END_TEST

START_TEST(units_that_cancel_leave_a_number) {
  Quantity q = parse_good("2 mm/m");
  ck_assert(q.value == 2e-3 && !q.has_unit);
}
END_TEST

START_TEST(what_is_no_quantity_is_refused_with_what_was_found) {
  static const struct {
    const char *text, *words;
  } table[] = {
      {"", "expected a number, found ``"},
      {"nan", "expected a number, found `nan`"},
      {".inf", "expected a number, found `.inf`"},
      {".", "expected a number, found `.`"},
      {"-", "expected a number"},
      {"e5", "expected a number"},
      {" 1", "expected a number"},
      {"0x10", "found `x10`"},
      {"1_000", "found `_000`"},
      {"1e", "found `e`"},
      {"1,5", "found `,5`"},
      {"1e400", "that double precision can hold, found `1e400`"},
      {"1e308 Gm", "that double precision can hold"},
      {"1 parsec", "expected a unit made of m, g, s, Hz, N, Pa, J, dyn, P or bar, found `parsec`"},
      {"1 N/", "expected a unit"},
      {"1 N.", "expected a unit"},
      {"1 N..m", "expected a unit"},
      {"1 u", "found `u`"},
      {"1 m ", "expected a unit"},
      {"1 m^", "expected a power from -9 to 9, not 0"},
      {"1 m^0", "expected a power"},
      {"1 m^10", "expected a power"},
      {"1 m^2^2", "expected a unit"},
      {"1 m^9.m", "expected a unit with powers from -9 to 9"},
      {"1 N/m.s", "only one unit behind a `/`"},
      {"1 N/m s", "only one unit behind a `/`"},
      {"1 1", "expected a unit"},
  };
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    Quantity quantity;
    Error error;
    ck_assert_msg(units_parse(table[i].text, &quantity, &error) == STATUS_INPUT, "taken: `%s`",
                  table[i].text);
    ck_assert_msg(strstr(error.text, table[i].words) != NULL, "%s: %s", table[i].text, error.text);
  }
}
END_TEST

START_TEST(units_alone_give_exponents_and_power_of_ten) {
  signed char dim[4];
  int decade;
  Error error;
  ck_assert_int_eq(units_parse_unit("mN/um", dim, &decade, &error), STATUS_OK);
  ck_assert_int_eq(decade, 3);
  ck_assert_mem_eq(dim, ((signed char[4]){1, 0, -2, 0}), 4);
  ck_assert_int_eq(units_parse_unit("J/m^2", dim, NULL, &error), STATUS_OK);
  ck_assert(units_agree(dim, (signed char[4]){1, 0, -2, 0}));
  ck_assert(!units_agree(dim, (signed char[4]){1, 0, -1, 0}));
  ck_assert_int_eq(units_parse_unit("", dim, NULL, &error), STATUS_INPUT);
}
END_TEST

START_TEST(numbers_are_printed_with_the_fewest_digits_that_read_back) {
  static const struct {
    double value;
    const char *text;
  } table[] = {{0.1, "0.1"},
               {0.7, "0.7"},
               {1e-4, "0.0001"},
               {35e-6, "3.5e-05"},
               {0.1 + 0.2, "0.30000000000000004"},
               {-0.0, "-0"},
               {100, "100"},
               {5e-324, "4.94065645841247e-324"}};
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    Text text = {0};
    Error error;
    ck_assert_int_eq(units_print_number(&text, table[i].value, &error), STATUS_OK);
    ck_assert_str_eq(text.data, table[i].text);
    text_free(&text);
  }
}
END_TEST

/* xorshift64: the same numbers on every machine */
static uint64_t random_bits(uint64_t *state) {
  *state ^= *state << 13;
  *state ^= *state >> 7;
  *state ^= *state << 17;
  return *state;
}

START_TEST(printed_quantities_read_back_bit_for_bit) {
  uint64_t state = 20210601;
  printf("seed %llu\n", (unsigned long long)state);
  for (int k = 0; k < 20000; k++) {
    Quantity q = {0}, again;
    uint64_t bits = random_bits(&state);
    memcpy(&q.value, &bits, sizeof bits);
    if (!isfinite(q.value)) continue;
    for (int i = 0; i < 3; i++) q.dim[i] = (signed char)((int)(random_bits(&state) % 7) - 3);
    q.has_unit = q.dim[0] || q.dim[1] || q.dim[2];
    Text text = {0};
    Error error;
    ck_assert_int_eq(units_print(&text, &q, &error), STATUS_OK);
    again = parse_good(text.data);
    ck_assert_msg(memcmp(&again.value, &q.value, sizeof q.value) == 0, "%s", text.data);
    ck_assert_mem_eq(again.dim, q.dim, 4);
    ck_assert_int_eq(again.has_unit, q.has_unit);
    text_free(&text);
  }
}
END_TEST

int main(void) {
  return suite_run("units", (SuiteTests){bare_numbers_are_kept_as_written,
                                         units_have_the_values_and_dimensions_of_the_si,
                                         units_that_cancel_leave_a_number,
                                         what_is_no_quantity_is_refused_with_what_was_found,
                                         units_alone_give_exponents_and_power_of_ten,
                                         numbers_are_printed_with_the_fewest_digits_that_read_back,
                                         printed_quantities_read_back_bit_for_bit, NULL});
}
