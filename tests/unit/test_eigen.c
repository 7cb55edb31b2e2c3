/* Eigenvalues of symmetric 3 x 3 matrices against matrices built from known ones. */
#include "base/vec3.h"
#include "linalg/eigen.h"
#include "random.h"
#include "suite.h"
#include <math.h>

/* Two random orthonormal vectors and their cross product. */
static void random_frame(uint64_t *state, double frame[3][3]) {
  random_fill(state, 6, &frame[0][0]);
  vec3_normalize(frame[0]);
  double along = vec3_dot(frame[0], frame[1]);
  for (int i = 0; i < 3; i++) frame[1][i] -= along * frame[0][i];
  vec3_normalize(frame[1]);
  vec3_cross(frame[0], frame[1], frame[2]);
}

START_TEST(known_eigenvalues_and_vectors_are_found_in_rising_order) {
  const uint64_t seed = 20210501;
  uint64_t state = seed;
  static const double value[3] = {-0.5, 1.25, 3.0};
  for (int trial = 0; trial < 200; trial++) {
    double frame[3][3], matrix[6], found[3], vector[3][3];
    Error error;
    random_frame(&state, frame);
    int entry = 0;
    for (int i = 0; i < 3; i++)
      for (int j = i; j < 3; j++) {
        matrix[entry] = 0.0;
        for (int k = 0; k < 3; k++) matrix[entry] += value[k] * frame[k][i] * frame[k][j];
        entry++;
      }
    ck_assert_int_eq(eigen_symmetric3(matrix, found, vector, &error), STATUS_OK);
    for (int k = 0; k < 3; k++) { /* round-off of a matrix of norm 3, gaps of order 1 */
      ck_assert_msg(fabs(found[k] - value[k]) < 1e-14, "seed %llu, trial %d, value %d: %.17g",
                    (unsigned long long)seed, trial, k, found[k]);
      ck_assert_msg(fabs(fabs(vec3_dot(vector[k], frame[k])) - 1.0) < 1e-14, "seed %llu, trial %d, vector %d",
                    (unsigned long long)seed, trial, k);
      ck_assert_double_eq_tol(vec3_norm(vector[k]), 1.0, 1e-15);
    }
  }
}
END_TEST

START_TEST(a_multiple_of_the_identity_gives_an_orthonormal_frame) {
  const double matrix[6] = {2.0, 0.0, 0.0, 2.0, 0.0, 2.0};
  double value[3], vector[3][3];
  Error error;
  ck_assert_int_eq(eigen_symmetric3(matrix, value, vector, &error), STATUS_OK);
  for (int k = 0; k < 3; k++) {
    ck_assert_double_eq(value[k], 2.0);
    for (int l = 0; l < 3; l++) ck_assert_double_eq_tol(vec3_dot(vector[k], vector[l]), k == l, 1e-15);
  }
}
END_TEST

START_TEST(a_matrix_that_is_not_finite_is_refused) {
  for (int k = 0; k < 6; k++) {
    double matrix[6] = {1.0, 0.0, 0.0, 1.0, 0.0, 1.0}, value[3], vector[3][3];
    Error error;
    matrix[k] = k % 2 ? NAN : INFINITY;
    ck_assert_int_eq(eigen_symmetric3(matrix, value, vector, &error), STATUS_REJECT);
  }
}
END_TEST

int main(void) {
  return suite_run("eigen", (SuiteTests){known_eigenvalues_and_vectors_are_found_in_rising_order,
                                         a_multiple_of_the_identity_gives_an_orthonormal_frame,
                                         a_matrix_that_is_not_finite_is_refused, NULL});
}
