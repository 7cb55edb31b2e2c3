/* Linear background flows and the axis about which they turn. */
#include "fluid/flow.h"
#include "suite.h"
#include <math.h>

static void assert_axis(const double gradient[3][3], double x, double y, double z) {
  Flow flow;
  flow_linear(&flow, gradient);
  const double expected[3] = {x, y, z};
  for (int i = 0; i < 3; i++) ck_assert_double_eq_tol(flow.vorticity_axis[i], expected[i], 1e-12);
}

START_TEST(velocity_is_gradient_times_position) {
  const double G[3][3] = {{1, 2, 3}, {4, 5, 6}, {7, 8, -6}};
  const double x[6] = {1, 0, -1, 0.5, 2, 0}, expected[6] = {-2, -2, 13, 4.5, 12, 19.5};
  double v[6];
  Flow flow;
  flow_linear(&flow, G);
  flow_velocity(&flow, 2, x, 3.0, v);
  for (int i = 0; i < 6; i++) ck_assert_double_eq_tol(v[i], expected[i], 1e-14);
}
END_TEST

START_TEST(a_flow_follows_its_strength_and_its_period) {
  const double G[3][3] = {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}}, points[][2] = {{0, 1}, {1, 3}, {1.5, 0}};
  const double x[3] = {0, 0, 2};
  double v[3];
  Flow flow;
  flow_linear(&flow, G);
  ck_assert_double_eq(flow_factor(&flow, 7), 1);
  flow.strength = (BrokenLine){points, 3};
  const double times[] = {0, 0.5, 1, 1.25, 1.5, 9}, factors[] = {1, 2, 3, 1.5, 0, 0};
  for (int i = 0; i < 6; i++) {
    flow_velocity(&flow, 1, x, times[i], v);
    ck_assert_double_eq_tol(v[0], 2 * factors[i], 1e-15);
  }
  flow.period = 2;
  flow_velocity(&flow, 1, x, 1, v);
  ck_assert_double_eq_tol(v[0], -6, 1e-14); /* half a period later */
  flow_velocity(&flow, 1, x, 0.5, v);
  ck_assert_double_eq_tol(v[0], 0, 1e-15);
}
END_TEST

START_TEST(simple_shear_turns_about_y) {
  const double shear[3][3] = {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  assert_axis(shear, 0, 1, 0);
}
END_TEST

START_TEST(axis_follows_the_sense_of_rotation) {
  const double spin[3][3] = {{0, -3, 0}, {3, 0, 0}, {0, 0, 0}},
               back[3][3] = {{0, 1, 0}, {0, 0, 0}, {0, 0, 0}};
  assert_axis(spin, 0, 0, 1);
  assert_axis(back, 0, 0, -1);
}
END_TEST

START_TEST(flow_without_vorticity_takes_the_intermediate_axis_of_strain) {
  const double planar[3][3] = {{1, 0, 0}, {0, 0, 0}, {0, 0, -1}};
  assert_axis(planar, 0, 1, 0);
  const double turned[3][3] = {{0, 1, 0}, {1, 0, 0}, {0, 0, 0}};
  assert_axis(turned, 0, 0, 1);
}
END_TEST

START_TEST(degenerate_strain_still_gives_a_unit_axis) {
  const double uniaxial[3][3] = {{1, 0, 0}, {0, -0.5, 0}, {0, 0, -0.5}};
  Flow flow;
  flow_linear(&flow, uniaxial);
  const double *axis = flow.vorticity_axis;
  ck_assert_double_eq_tol(axis[0], 0, 1e-12);
  ck_assert_double_eq_tol(hypot(axis[1], axis[2]), 1, 1e-12);
}
END_TEST

int main(void) {
  return suite_run("flow", (SuiteTests){velocity_is_gradient_times_position,
                                        a_flow_follows_its_strength_and_its_period,
                                        simple_shear_turns_about_y, axis_follows_the_sense_of_rotation,
                                        flow_without_vorticity_takes_the_intermediate_axis_of_strain,
                                        degenerate_strain_still_gives_a_unit_axis, NULL});
}
