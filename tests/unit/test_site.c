/* Angles of a place on the capsule to its axes. */
#include "observe/site.h"

#include "suite.h"
#include <math.h>

static const double e_y[3] = {0, 1, 0};

/* A capsule at (1, 2, 3) whose major axis lies 30 degrees above e_x. */
static Shape inclined(void) {
  return (Shape){.center = {1, 2, 3}, .e1 = {sqrt(0.75), 0, 0.5}};
}

START_TEST(a_tip_of_the_major_axis_is_at_no_angle_to_it_and_square_to_the_vorticity) {
  const Shape shape = inclined();
  for (int side = -1; side <= 1; side += 2) {
    const double X[3] = {1, 0, 0}, x[3] = {1 + side * 2 * shape.e1[0], 2, 3 + side * 2 * shape.e1[2]};
    const Site site = site_measure(&shape, e_y, X, x);
    ck_assert_double_eq_tol(site.angle_to_major_axis_deg, 0, 3e-6); /* acos near 1: sqrt(eps) */
    ck_assert_double_eq_tol(site.angle_to_vorticity_deg, 90, 1e-12);
    for (int c = 0; c < 3; c++) {
      ck_assert_double_eq(site.X[c], X[c]);
      ck_assert_double_eq(site.x[c], x[c]);
    }
  }
}
END_TEST

START_TEST(a_place_between_the_axes_is_at_the_angles_of_its_direction) {
  const Shape shape = inclined();
  const double X[3] = {0, 1, 0}, x[3] = {1, 2 + 3, 3 + 3}; /* 45 degrees from e_y, acos(1/sqrt 8) from e1 */
  const Site site = site_measure(&shape, e_y, X, x);
  ck_assert_double_eq_tol(site.angle_to_vorticity_deg, 45, 1e-12);
  ck_assert_double_eq_tol(site.angle_to_major_axis_deg, 69.295188945, 1e-8);
}
END_TEST

int main(void) {
  return suite_run("site",
                   (SuiteTests){a_tip_of_the_major_axis_is_at_no_angle_to_it_and_square_to_the_vorticity,
                                a_place_between_the_axes_is_at_the_angles_of_its_direction, NULL});
}
