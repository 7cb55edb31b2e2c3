/* The picture of the capsule as an SVG document. */
#include "observe/picture.h"

#include "base/array.h"
#include "markup.h"
#include "suite.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static Mesh mesh;
static double *field;

static Picture of_sphere(int subdivisions) {
  Error error;
  array_free(field);
  mesh_free(&mesh);
  ck_assert_int_eq(mesh_sphere(&mesh, subdivisions, NULL, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&field, mesh.n_nodes, &error), STATUS_OK);
  for (int p = 0; p < mesh.n_nodes; p++) field[p] = 0.2 * pow(mesh.X[3 * p + 1], 2);
  return (Picture){.mesh = &mesh,
                   .x = mesh.X,
                   .field = field,
                   .label = "d",
                   .views = picture_shear_views,
                   .n_views = 2,
                   .axes = picture_shear_axes,
                   .n_axes = 3};
}

static Text printed(const Picture *picture) {
  Error error;
  Text svg = {0};
  ck_assert_msg(picture_print(picture, &svg, &error) == STATUS_OK, "%s", error.text);
  return svg;
}

static int occurrences(const Text *text, const char *word) {
  int count = 0;
  for (const char *at = text->data; (at = strstr(at, word)); at++) count++;
  return count;
}

START_TEST(the_document_is_well_formed) {
  const Picture picture = of_sphere(1);
  Text svg = printed(&picture);
  ck_assert(markup_is_nested(svg.data));
  ck_assert_int_eq(strncmp(svg.data, "<svg xmlns=", 11), 0);
  ck_assert_int_eq(occurrences(&svg, "nan") + occurrences(&svg, "inf"), 0);
  text_free(&svg);
}
END_TEST

START_TEST(views_axes_and_colour_bar_are_labelled) {
  const Picture picture = of_sphere(0);
  Text svg = printed(&picture);
  const char *const once[] = {">along the vorticity axis<",
                              ">along the velocity gradient<",
                              ">d<",
                              ">0<",
                              ">0.05<",
                              ">0.1<",
                              ">0.15<",
                              ">0.2<"};
  for (size_t k = 0; k < sizeof once / sizeof *once; k++)
    ck_assert_msg(occurrences(&svg, once[k]) == 1, "%s", once[k]);
  const char *const in_each_view[] = {">flow<", ">gradient<", ">vorticity<"};
  for (size_t k = 0; k < 3; k++) ck_assert_int_eq(occurrences(&svg, in_each_view[k]), 2);
  ck_assert_int_eq(occurrences(&svg, "d=\"M-4 -4L4 4M-4 4L4 -4\""),
                   1);                                 /* vorticity away from the first eye */
  ck_assert_int_eq(occurrences(&svg, "r=\"1.5\""), 1); /* gradient toward the second */
  text_free(&svg);
}
END_TEST

START_TEST(labels_are_escaped) {
  Picture picture = of_sphere(0);
  picture.label = "a < b & c > d";
  Text svg = printed(&picture);
  ck_assert_int_eq(occurrences(&svg, ">a &lt; b &amp; c &gt; d</text>"), 1);
  text_free(&svg);
}
END_TEST

START_TEST(without_a_field_there_is_no_colour_bar) {
  Picture picture = of_sphere(1);
  picture.field = NULL;
  Text svg = printed(&picture);
  ck_assert_int_eq(occurrences(&svg, "linearGradient"), 0);
  ck_assert_int_eq(occurrences(&svg, "width=\"760\""), 1);
  text_free(&svg);
}
END_TEST

START_TEST(the_bar_keeps_a_range_that_is_given) {
  Picture picture = of_sphere(0);
  picture.minimum = -1;
  picture.maximum = 1;
  Text svg = printed(&picture);
  ck_assert_int_eq(occurrences(&svg, ">-1<") + occurrences(&svg, ">0<") + occurrences(&svg, ">1<"), 3);
  text_free(&svg);
}
END_TEST

START_TEST(a_constant_field_is_drawn) {
  Picture picture = of_sphere(0);
  for (int p = 0; p < mesh.n_nodes; p++) field[p] = 0;
  Text svg = printed(&picture);
  ck_assert_int_eq(occurrences(&svg, "nan"), 0);
  ck_assert_int_eq(occurrences(&svg, ">0<"), 1);
  text_free(&svg);
}
END_TEST

START_TEST(round_off_is_not_spread_over_the_colours) {
  const Picture picture = of_sphere(0);
  for (int p = 0; p < mesh.n_nodes; p++) field[p] = 2 + (p % 2 ? 4e-16 : 0);
  Text svg = printed(&picture); /* the bar goes from 2 to 4 */
  ck_assert_int_eq(occurrences(&svg, ">2<") + occurrences(&svg, ">3<") + occurrences(&svg, ">4<"), 3);
  text_free(&svg);
}
END_TEST

START_TEST(a_mark_is_drawn_in_the_views_that_see_it) {
  static const PictureMark marks[] = {{.x = {0, -1, 0}, .label = "front"},
                                      {.x = {0, 1, 0}, .label = "back"},
                                      {.x = {0, 0, 1}, .label = "top"}};
  static const PictureView from_front[] = {{{0, -1, 0}, {0, 0, 1}, NULL, false}};
  Picture picture = of_sphere(0);
  picture.field = NULL;
  picture.views = from_front;
  picture.n_views = 1;
  picture.n_axes = 0;
  picture.marks = marks;
  picture.n_marks = 3;
  Text svg = printed(&picture);
  ck_assert_int_eq(occurrences(&svg, "<circle"), 2);
  ck_assert_int_eq(occurrences(&svg, ">front<"), 1);
  ck_assert_int_eq(occurrences(&svg, ">top<"), 1); /* on the outline */
  ck_assert_int_eq(occurrences(&svg, "back"), 0);
  text_free(&svg);
}
END_TEST

START_TEST(a_mark_behind_shines_through_where_that_is_asked_for) {
  static const PictureMark behind = {.x = {0, 1, 0}, .label = "back"};
  static const PictureView from_front = {{0, -1, 0}, {0, 0, 1}, NULL, false};
  Picture picture = of_sphere(0);
  picture.views = &from_front;
  picture.n_views = 1;
  picture.n_axes = 0;
  picture.marks = &behind;
  picture.n_marks = 1;
  picture.marks_shine_through = true;
  Text svg = printed(&picture);
  ck_assert_int_eq(occurrences(&svg, "<circle"), 1);
  ck_assert_int_eq(occurrences(&svg, " opacity=\"0.6\""), 1);
  ck_assert_int_eq(occurrences(&svg, ">back<"), 1);
  text_free(&svg);
}
END_TEST

/* Far away and twice as large at present: each stands in the middle of its view, at the same scale. */
START_TEST(the_capsule_at_rest_stands_beside_the_deformed_one) {
  static const PictureView views[] = {{{0, -1, 0}, {0, 0, 1}, NULL, false},
                                      {{0, -1, 0}, {0, 0, 1}, NULL, true}};
  static const PictureMark tip = {.x = {102, 0, 0}, .X = {1, 0, 0}, .label = "tip"};
  Picture picture = of_sphere(1);
  Error error;
  double *x;
  ck_assert_int_eq(ARRAY_NEW(&x, 3 * mesh.n_nodes, &error), STATUS_OK);
  for (int k = 0; k < 3 * mesh.n_nodes; k++) x[k] = 2 * mesh.X[k] + 100 * (k % 3 == 0);
  picture.x = x;
  picture.X = mesh.X;
  picture.views = views;
  picture.n_views = 2;
  picture.n_axes = 0;
  picture.marks = &tip;
  picture.n_marks = 1;
  Text svg = printed(&picture);
  double at[2];
  const char *circle = svg.data;
  for (int k = 0; k < 2; k++) {
    ck_assert_ptr_nonnull(circle = strstr(circle, "<circle cx=\""));
    ck_assert_int_eq(sscanf(circle, "<circle cx=\"%lf\"", &at[k]), 1);
    circle++;
  }
  const double middle = 190; /* of a view of 380 pixels; round-off of the file: 0.1 */
  ck_assert_double_eq_tol((at[0] - middle) / (at[1] - middle), 2, 0.01);
  array_free(x);
  text_free(&svg);
}
END_TEST

START_TEST(marks_that_fall_together_are_one_dot_with_both_labels) {
  static const PictureMark marks[] = {{.x = {0, -1, 0}, .label = "1"},
                                      {.x = {0.7, -0.7, 0}, .label = "2"},
                                      {.x = {0.01, -1, 0}, .label = "3"}};
  static const char *const legend[] = {"1 first", "2 <second>"};
  static const PictureView from_front[] = {{{0, -1, 0}, {0, 0, 1}, NULL, false}};
  Picture picture = of_sphere(0);
  picture.views = from_front;
  picture.n_views = 1;
  picture.n_axes = 0;
  picture.marks = marks;
  picture.n_marks = 3;
  picture.legend = legend;
  picture.n_legend = 2;
  Text svg = printed(&picture);
  ck_assert_int_eq(occurrences(&svg, "<circle"), 2);
  ck_assert_int_eq(occurrences(&svg, ">1 3<"), 1);
  ck_assert_int_eq(occurrences(&svg, ">2<"), 1);
  ck_assert_int_eq(occurrences(&svg, "2 &lt;second&gt;"), 1);
  text_free(&svg);
}
END_TEST

START_TEST(the_file_stays_below_a_megabyte_and_a_half) {
  for (int subdivisions = 0; subdivisions <= 5; subdivisions++) {
    const Picture picture = of_sphere(subdivisions);
    Text svg = printed(&picture);
    ck_assert(svg.length > 10000 && svg.length < 1500000);
    text_free(&svg);
  }
}
END_TEST

START_TEST(what_is_not_finite_is_refused_with_its_node) {
  Error error;
  Text svg = {0};
  Picture picture = of_sphere(0);
  field[7] = NAN;
  ck_assert_int_eq(picture_print(&picture, &svg, &error), STATUS_INPUT);
  ck_assert_str_eq(error.text, "picture: expected a finite field value, found nan at node 7");
  picture = of_sphere(0);
  mesh.X[3 * 5 + 1] = INFINITY;
  ck_assert_int_eq(picture_print(&picture, &svg, &error), STATUS_INPUT);
  ck_assert_str_eq(error.text, "picture: expected a finite position, found inf at node 5");
  picture = of_sphere(0);
  picture.views = &(PictureView){{0, 0, 0}, {0, 0, 1}, NULL, false};
  picture.n_views = 1;
  ck_assert_int_eq(picture_print(&picture, &svg, &error), STATUS_INPUT);
  text_free(&svg);
}
END_TEST

int main(void) {
  int result =
      suite_run("picture", (SuiteTests){the_document_is_well_formed, views_axes_and_colour_bar_are_labelled,
                                        labels_are_escaped, without_a_field_there_is_no_colour_bar,
                                        the_bar_keeps_a_range_that_is_given, a_constant_field_is_drawn,
                                        round_off_is_not_spread_over_the_colours,
                                        a_mark_is_drawn_in_the_views_that_see_it,
                                        a_mark_behind_shines_through_where_that_is_asked_for,
                                        the_capsule_at_rest_stands_beside_the_deformed_one,
                                        marks_that_fall_together_are_one_dot_with_both_labels,
                                        the_file_stays_below_a_megabyte_and_a_half,
                                        what_is_not_finite_is_refused_with_its_node, NULL});
  array_free(field);
  mesh_free(&mesh);
  return result;
}
