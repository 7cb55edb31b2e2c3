/* A sheet of maps: a place for every panel, ranges by row, and refusals. */
#include "observe/sheet.h"

#include "base/array.h"
#include "suite.h"
#include <math.h>
#include <string.h>

typedef struct {
  Mesh mesh;
  double *height;
} Ball;

static Ball ball_new(void) {
  Ball ball;
  Error error;
  ck_assert_int_eq(mesh_sphere(&ball.mesh, 1, NULL, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&ball.height, ball.mesh.n_nodes, &error), STATUS_OK);
  for (int k = 0; k < ball.mesh.n_nodes; k++) ball.height[k] = ball.mesh.X[3 * k + 2];
  return ball;
}

static void ball_free(Ball *ball) {
  array_free(ball->height);
  mesh_free(&ball->mesh);
}

static int count_of(const Text *text, const char *word) {
  int n = 0;
  for (const char *at = text->data; (at = strstr(at, word)); at += strlen(word)) n++;
  return n;
}

static Status print(const Ball *ball, const SheetRow *rows, size_t n_rows, Text *svg, Error *error) {
  static const char *const columns[] = {"t = 1", "t < 2", "t = 3"};
  SheetPanel panels[6];
  for (int k = 0; k < 6; k++)
    panels[k] = (SheetPanel){&ball->mesh, ball->mesh.X, ball->height, picture_shear_views[k % 2]};
  return sheet_print(
      &(Sheet){.rows = rows, .n_rows = n_rows, .columns = columns, .n_columns = 3, .panels = panels}, svg,
      error);
}

START_TEST(every_state_has_a_place_in_every_row) {
  Ball ball = ball_new();
  Text svg = {0};
  Error error;
  const SheetRow rows[] = {{.label = "first & only"}, {.label = "second", .minimum = 0, .maximum = 10}};
  ck_assert_int_eq(print(&ball, rows, 2, &svg, &error), STATUS_OK);
  ck_assert_int_eq(count_of(&svg, "scale("), 6);
  ck_assert_int_eq(count_of(&svg, "stroke=\"#000\""), 6); /* the line around each */
  ck_assert_int_eq(count_of(&svg, "t &lt; 2"), 1);
  ck_assert_int_eq(count_of(&svg, "first &amp; only"), 1);
  ck_assert_int_eq(count_of(&svg, ">10<"), 1); /* on the bar of the second row alone */
  text_free(&svg);
  ball_free(&ball);
}
END_TEST

START_TEST(what_is_not_finite_is_refused) {
  Ball ball = ball_new();
  Text svg = {0};
  Error error;
  const SheetRow row = {.label = "d"};
  ball.height[7] = NAN;
  ck_assert_int_eq(print(&ball, &row, 1, &svg, &error), STATUS_INPUT);
  ck_assert_ptr_nonnull(strstr(error.text, "node 7"));
  text_free(&svg);
  ball_free(&ball);
}
END_TEST

int main(void) {
  return suite_run("sheet",
                   (SuiteTests){every_state_has_a_place_in_every_row, what_is_not_finite_is_refused, NULL});
}
