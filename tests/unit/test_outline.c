/* Outlines of what is seen of a field: the areas that they enclose, and their loops. */
#include "observe/outline.h"

#include "base/array.h"
#include "suite.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

enum { SCALE = 2000, CUTS = 3 };

/* The loops of a path: how many, and the area they enclose, in lengths. */
typedef struct {
  int loops;
  double area;
} Enclosed;

static Enclosed read_path(const Text *path) {
  Enclosed result = {0};
  const char *at = path->data ? path->data : "";
  while (*at) {
    double x, y, twice = 0, x0, y0;
    int length;
    ck_assert_int_eq(sscanf(at, "M%lf %lfl%n", &x, &y, &length), 2);
    x0 = x;
    y0 = y;
    for (at += length; *at != 'z'; at += length) {
      double dx, dy;
      ck_assert_int_eq(sscanf(at, "%lf%lf %n", &dx, &dy, &length), 2);
      twice += x * (y + dy) - y * (x + dx);
      x += dx;
      y += dy;
    }
    at++;
    twice += x * y0 - y * x0;
    result.area -= twice / 2 / SCALE / SCALE; /* y runs downwards */
    result.loops++;
  }
  return result;
}

/* The field is the height above the equator (|height| with `both` set) of a unit sphere seen along `toward`.
 */
static Enclosed outline_of(const double toward[3], bool both, double level) {
  Mesh mesh;
  Error error;
  Projection projection;
  Piece *pieces;
  double *field;
  size_t count;
  Text path = {0};
  ck_assert_int_eq(mesh_sphere(&mesh, 3, NULL, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&field, mesh.n_nodes, &error), STATUS_OK);
  for (int k = 0; k < mesh.n_nodes; k++) field[k] = both ? fabs(mesh.X[3 * k + 2]) : mesh.X[3 * k + 2];
  ck_assert_int_eq(projection_make(&projection, toward, (const double[]){0, 1, 0}, &error), STATUS_OK);
  ck_assert_int_eq(projection_pieces(&projection, &mesh, mesh.X, field, (const double[]){0, 0, 0}, CUTS,
                                     &pieces, &count, &error),
                   STATUS_OK);
  ck_assert_int_eq(outline_print(pieces, count, level, SCALE, &path, &error), STATUS_OK);
  const Enclosed result = read_path(&path);
  array_free(pieces);
  array_free(field);
  text_free(&path);
  mesh_free(&mesh);
  return result;
}

/* Pieces are flat and half a piece (0.03) of the rim may be missing: 1 % of the area. */
START_TEST(a_sphere_is_seen_as_a_disc) {
  const Enclosed disc = outline_of((const double[]){0.3, 0.2, 1}, false, -INFINITY);
  ck_assert_int_eq(disc.loops, 1);
  ck_assert_double_eq_tol(disc.area, acos(-1), 0.01 * acos(-1));
}
END_TEST

/* Seen from above, height >= level is a disc of radius sqrt(1 - level^2).  Flat pieces with edges up to 0.06
 * lie up to 0.06^2/8 inside the sphere, which takes at most 2 pi times that off the area: 2.8e-3. */
START_TEST(the_part_above_a_level_is_cut_out_exactly) {
  for (double level = 0.2; level < 0.95; level += 0.1) {
    const Enclosed cap = outline_of((const double[]){0, 0, 1}, false, level);
    ck_assert_int_eq(cap.loops, 1);
    ck_assert_double_eq_tol(cap.area, acos(-1) * (1 - level * level), 3e-3);
  }
}
END_TEST

START_TEST(two_parts_are_two_loops) {
  ck_assert_int_eq(outline_of((const double[]){1, 0, 0}, true, 0.5).loops, 2);
}
END_TEST

START_TEST(a_level_that_is_not_reached_has_no_outline) {
  ck_assert_int_eq(outline_of((const double[]){0, 0, 1}, false, 1.1).loops, 0);
}
END_TEST

int main(void) {
  return suite_run("outline",
                   (SuiteTests){a_sphere_is_seen_as_a_disc, the_part_above_a_level_is_cut_out_exactly,
                                two_parts_are_two_loops, a_level_that_is_not_reached_has_no_outline, NULL});
}
