/* What a scene says against the table of a law. */
#include "law_scene.h"
#include "laws/parameters.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* A table with one parameter of each sort. */
enum { STIFFNESS, RATIO, RATE, N_PARAMS };
static const mlaw_param table[N_PARAMS] = {
    [STIFFNESS] = {"G", "N/m", "stiffness", {1, 0, -2, 0}, MLAW_OPEN_LO, 1.0, 0.0, INFINITY, 0.0, INFINITY},
    [RATIO] = {"ratio", "1", "a ratio", {0}, MLAW_OPEN_HI, 0.5, 0.0, 1.0, 0.1, 0.9},
    [RATE] = {"rate", "1/s", "a rate", {0, 0, -1, 0}, MLAW_REQUIRED, 0.0, 0.0, 100.0, 0.0, 100.0},
};

static int check(const double *param, mlaw_error *err) {
  if (param[RATIO] * param[RATE] <= 10.0) return MLAW_OK;
  return mlaw_fail(err, MLAW_BADPARAM, -1, "ratio times rate is beyond 10");
}

static const LawDescription LAW = {.id = "test.law",
                                   .params = table,
                                   .n_params = N_PARAMS,
                                   .param_size = sizeof(mlaw_param),
                                   .check = check};

static Status fill(SceneParameter *given, size_t n, const LawScales *scales, Log *log, double *value,
                   Error *error) {
  const SceneLaw scene = scene_law("test.law", given, n);
  ParameterValues values;
  const Status status = law_parameters(&LAW, &scene, scales, NULL, log, &values, error);
  if (status == STATUS_OK) memcpy(value, values.value, N_PARAMS * sizeof *value);
  parameter_values_free(&values);
  return status;
}

static void expect_refusal(SceneParameter *given, size_t n, const char *message) {
  double value[N_PARAMS];
  Error error;
  ck_assert_int_eq(fill(given, n, &NO_SCALES, NULL, value, &error), STATUS_INPUT);
  ck_assert_str_eq(error.text, message);
}

START_TEST(what_the_scene_does_not_give_has_its_default) {
  double value[N_PARAMS];
  Error error;
  SceneParameter given[] = {number("rate", 3.0)};
  ck_assert_int_eq(fill(given, 1, &NO_SCALES, NULL, value, &error), STATUS_OK);
  ck_assert_double_eq(value[STIFFNESS], 1.0);
  ck_assert_double_eq(value[RATIO], 0.5);
  ck_assert_double_eq(value[RATE], 3.0);
}
END_TEST

START_TEST(a_quantity_with_unit_is_divided_by_the_scales_and_a_bare_number_is_not) {
  double value[N_PARAMS];
  Error error;
  /* 2 kg, 5 m, 0.1 s: a tension unit of 200 N/m, a rate unit of 10/s */
  const LawScales scales = {2.0, 5.0, 0.1};
  SceneParameter given[] = {number("G", 50.0), number("rate", 3.0)};
  given[0].value.has_unit = true;
  memcpy(given[0].value.dim, (const signed char[4]){1, 0, -2, 0}, 4);
  ck_assert_int_eq(fill(given, 2, &scales, NULL, value, &error), STATUS_OK);
  ck_assert_double_eq_tol(value[STIFFNESS], 0.25, 1e-15);
  ck_assert_double_eq(value[RATE], 3.0);
}
END_TEST

START_TEST(a_pressure_where_a_tension_belongs_is_refused) {
  SceneParameter given[] = {number("G", 1.0), number("rate", 1.0)};
  given[0].value.has_unit = true;
  memcpy(given[0].value.dim, (const signed char[4]){1, -1, -2, 0}, 4);
  expect_refusal(given, 2, "scene.yaml:7:20: parameter G of law test.law: expected N/m, found Pa");
  memcpy(given[0].value.dim, (const signed char[4]){0, 2, -1, 0}, 4);
  expect_refusal(given, 2, "scene.yaml:7:20: parameter G of law test.law: expected N/m, found kg^0 m^2 s^-1");
}
END_TEST

START_TEST(a_unit_on_a_dimensionless_parameter_is_refused) {
  SceneParameter given[] = {number("ratio", 0.5), number("rate", 1.0)};
  given[0].value.has_unit = true;
  memcpy(given[0].value.dim, (const signed char[4]){0, 1, 0, 0}, 4);
  expect_refusal(given, 2,
                 "scene.yaml:7:20: parameter ratio of law test.law: expected a number without unit, found m");
}
END_TEST

START_TEST(a_unit_in_a_scene_without_scales_is_refused) {
  double value[N_PARAMS];
  Error error;
  SceneParameter given[] = {number("G", 1.0), number("rate", 1.0)};
  given[0].value.has_unit = true;
  memcpy(given[0].value.dim, (const signed char[4]){1, 0, -2, 0}, 4);
  ck_assert_int_eq(fill(given, 2, NULL, NULL, value, &error), STATUS_INPUT);
  ck_assert_str_eq(error.text,
                   "scene.yaml:7:20: parameter G of law test.law: expected a number without unit, since "
                   "the scene gives no physical scales, found N/m");
}
END_TEST

START_TEST(an_unknown_name_is_answered_with_the_nearest) {
  SceneParameter given[] = {number("Rato", 0.5)};
  expect_refusal(given, 1,
                 "scene.yaml:7:20: law test.law has no parameter `Rato` (did you mean `ratio`?); it has: G, "
                 "ratio, rate");
}
END_TEST

START_TEST(a_required_parameter_that_is_missing_is_named_with_its_meaning) {
  expect_refusal(NULL, 0,
                 "scene.yaml:5:8: law test.law: expected the parameter rate (a rate; unit 1/s), found none");
}
END_TEST

START_TEST(each_end_of_a_hard_range_is_open_or_closed_as_the_table_says) {
  double value[N_PARAMS];
  Error error;
  SceneParameter given[] = {number("rate", 1.0), number("G", 0.0)};
  expect_refusal(given, 2, "scene.yaml:7:20: parameter G of law test.law: expected more than 0, found 0");
  given[1] = number("ratio", 1.0);
  expect_refusal(given, 2, "scene.yaml:7:20: parameter ratio of law test.law: expected less than 1, found 1");
  given[1] = number("ratio", -0.1);
  expect_refusal(given, 2,
                 "scene.yaml:7:20: parameter ratio of law test.law: expected at least 0, found -0.1");
  given[1] = number("ratio", 0.0);
  given[0] = number("rate", 100.0);
  ck_assert_int_eq(fill(given, 2, &NO_SCALES, NULL, value, &error), STATUS_OK);
  given[0] = number("rate", 101.0);
  expect_refusal(given, 2,
                 "scene.yaml:7:20: parameter rate of law test.law: expected at most 100, found 101");
}
END_TEST

START_TEST(a_value_that_is_not_finite_is_refused) {
  SceneParameter given[] = {number("rate", 1.0), number("G", INFINITY)};
  expect_refusal(given, 2,
                 "scene.yaml:7:20: parameter G of law test.law: expected a finite number, found inf");
  given[1] = number("G", NAN);
  expect_refusal(given, 2,
                 "scene.yaml:7:20: parameter G of law test.law: expected a finite number, found nan");
}
END_TEST

START_TEST(the_law_has_its_say_across_parameters) {
  SceneParameter given[] = {number("rate", 50.0), number("ratio", 0.5)};
  expect_refusal(given, 2,
                 "scene.yaml:5:8: law test.law refuses its parameters: ratio times rate is beyond 10");
}
END_TEST

START_TEST(leaving_the_calibrated_range_warns_once_and_goes_on) {
  double value[N_PARAMS];
  Error error;
  char line[256];
  Log log = {.file = tmpfile(), .quiet = true};
  SceneParameter given[] = {number("rate", 1.0), number("ratio", 0.95)};
  ck_assert_int_eq(fill(given, 2, &NO_SCALES, &log, value, &error), STATUS_OK);
  ck_assert_double_eq(value[RATIO], 0.95);
  ck_assert_int_eq(log.warnings, 1);
  rewind(log.file);
  ck_assert_ptr_nonnull(fgets(line, sizeof line, log.file));
  ck_assert_ptr_nonnull(strstr(
      line,
      "scene.yaml:7:20: parameter ratio = 0.95 is outside 0.1 .. 0.9, where law test.law was calibrated"));
  given[1] = number("ratio", 0.9);
  ck_assert_int_eq(fill(given, 2, &NO_SCALES, &log, value, &error), STATUS_OK);
  ck_assert_int_eq(log.warnings, 1);
  fclose(log.file);
}
END_TEST

int main(void) {
  return suite_run(
      "parameters",
      (SuiteTests){
          what_the_scene_does_not_give_has_its_default,
          a_quantity_with_unit_is_divided_by_the_scales_and_a_bare_number_is_not,
          a_pressure_where_a_tension_belongs_is_refused, a_unit_on_a_dimensionless_parameter_is_refused,
          a_unit_in_a_scene_without_scales_is_refused, an_unknown_name_is_answered_with_the_nearest,
          a_required_parameter_that_is_missing_is_named_with_its_meaning,
          each_end_of_a_hard_range_is_open_or_closed_as_the_table_says, a_value_that_is_not_finite_is_refused,
          the_law_has_its_say_across_parameters, leaving_the_calibrated_range_warns_once_and_goes_on, NULL});
}
