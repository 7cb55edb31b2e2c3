/* The table of keys holds together. */
#include "config/schema.h"
#include "config/value.h"
#include "suite.h"
#include <string.h>

START_TEST(keys_are_unique_and_no_value_is_also_a_mapping) {
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    ck_assert_ptr_eq(schema_find(SCHEMA[i].key), &SCHEMA[i]);
    ck_assert_msg(schema_is_mapping(SCHEMA[i].key) == (SCHEMA[i].type == TYPE_GROUP), "%s", SCHEMA[i].key);
  }
  ck_assert_ptr_null(schema_find("flow"));
  ck_assert(schema_is_mapping("flow") && !schema_is_mapping("flo") && !schema_is_mapping("flow."));
}
END_TEST

START_TEST(every_row_says_what_it_means_in_one_sentence) {
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    const char *meaning = SCHEMA[i].meaning;
    ck_assert_msg(meaning && meaning[strlen(meaning) - 1] == '.', "%s", SCHEMA[i].key);
    ck_assert_ptr_null(strchr(meaning, '|')); /* it stands in a table of Markdown */
  }
}
END_TEST

START_TEST(no_two_rows_land_in_the_same_place) {
  for (size_t i = 0; i < SCHEMA_ROWS; i++)
    for (size_t j = 0; j < i; j++) {
      bool is_law =
          SCHEMA[i].type == TYPE_PARAMETERS && SCHEMA[j].type == TYPE_LAW; /* two parts of a SceneLaw */
      ck_assert_msg(is_law || SCHEMA[i].offset != SCHEMA[j].offset, "%s, %s", SCHEMA[i].key, SCHEMA[j].key);
    }
}
END_TEST

/* Reads a value of a row into an empty scene. */
static Status read_value(const SchemaRow *row, const char *text, Scene *scene, Error *error) {
  YamlNode *node;
  *scene = (Scene){0};
  ck_assert_int_eq(yaml_tree_parse(&node, "test", false, text, strlen(text), error), STATUS_OK);
  Status status = value_read(row, node, scene, error);
  yaml_tree_free(node);
  return status;
}

START_TEST(defaults_are_values_of_their_own_rows) {
  for (size_t i = 0; i < SCHEMA_ROWS; i++)
    for (int accuracy = ACCURACY_DRAFT; accuracy <= ACCURACY_FINE; accuracy++) {
      const char *value = schema_default(&SCHEMA[i], (Accuracy)accuracy);
      if (!value) continue;
      Scene scene;
      Error error;
      Status status = read_value(&SCHEMA[i], value, &scene, &error);
      ck_assert_msg(status == STATUS_OK, "%s", error.text);
      value_free(&SCHEMA[i], &scene);
    }
}
END_TEST

START_TEST(examples_have_the_dimension_of_their_rows) {
  int examples = 0;
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    ck_assert_int_eq(SCHEMA[i].example != NULL, SCHEMA[i].type == TYPE_QUANTITY);
    if (!SCHEMA[i].example) continue;
    Scene scene;
    Error error;
    Status status = read_value(&SCHEMA[i], SCHEMA[i].example, &scene, &error);
    ck_assert_msg(status == STATUS_OK, "%s", error.text);
    examples++;
  }
  ck_assert_int_eq(examples, 4); /* radius, viscosity, rate, modulus */
}
END_TEST

START_TEST(choices_can_all_be_read_and_printed) {
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    if (SCHEMA[i].type != TYPE_CHOICE) continue;
    for (int k = 0; SCHEMA[i].choices[k]; k++) {
      Scene scene;
      Error error;
      Text text = {0};
      ck_assert_int_eq(read_value(&SCHEMA[i], SCHEMA[i].choices[k], &scene, &error), STATUS_OK);
      ck_assert_int_eq(value_print(&SCHEMA[i], &scene, &text, &error), STATUS_OK);
      ck_assert_str_eq(text.data, SCHEMA[i].choices[k]);
      text_free(&text);
    }
  }
}
END_TEST

static void expect_suggestion(const char *key, const char *expected) {
  Text suggestion = {0};
  Error error;
  ck_assert_int_eq(schema_suggest(key, &suggestion, &error), STATUS_OK);
  ck_assert_str_eq(suggestion.data ? suggestion.data : "", expected);
  text_free(&suggestion);
}

START_TEST(suggestions_are_neighbours_first_then_namesakes_elsewhere) {
  expect_suggestion("flwo", "flow");
  expect_suggestion("membrane.damge", "membrane.damage");
  expect_suggestion("capsule.mesh.rotation.axes", "capsule.mesh.rotation.axis");
  expect_suggestion("integrator", "time.integrator");
  expect_suggestion("flow.end", "time.end");
  expect_suggestion("temperature", "");
}
END_TEST

int main(void) {
  return suite_run(
      "schema", (SuiteTests){keys_are_unique_and_no_value_is_also_a_mapping,
                             every_row_says_what_it_means_in_one_sentence, no_two_rows_land_in_the_same_place,
                             defaults_are_values_of_their_own_rows, examples_have_the_dimension_of_their_rows,
                             choices_can_all_be_read_and_printed,
                             suggestions_are_neighbours_first_then_namesakes_elsewhere, NULL});
}
