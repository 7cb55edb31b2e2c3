/* Names for the parts of a capsule (the maps are tested with the study `compare`). */
#include "study/sites.h"

#include "suite.h"
#include <math.h>

START_TEST(a_site_is_named_by_the_axis_that_it_is_near) {
  ck_assert_str_eq(site_region(0, 90), "vorticity_axis");
  ck_assert_str_eq(site_region(19, 75), "vorticity_axis");
  ck_assert_str_eq(site_region(88, 12), "major_tip");
  ck_assert_str_eq(site_region(85, 35), "shear_plane");
  ck_assert_str_eq(site_region(45, 60), "elsewhere");
}
END_TEST

START_TEST(an_unknown_angle_has_no_name) {
  ck_assert_str_eq(site_region(NAN, NAN), "");
}
END_TEST

int main(void) {
  return suite_run(
      "sites", (SuiteTests){a_site_is_named_by_the_axis_that_it_is_near, an_unknown_angle_has_no_name, NULL});
}
