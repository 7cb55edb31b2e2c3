/* Quadrature rules against the closed forms of the monomials. */
#include "mesh/quadrature.h"

#include "suite.h"
#include <math.h>

static const int rule_sizes[] = {1, 3, 6, 7, 12, 16};
enum { N_RULES = sizeof rule_sizes / sizeof *rule_sizes };

static double factorial(int n) {
  return n < 2 ? 1.0 : n * factorial(n - 1);
}

/* int xi^i eta^j over the triangle by a rule. */
static double triangle_sum(const TriangleRule *rule, int i, int j) {
  double sum = 0.0;
  for (int g = 0; g < rule->n; g++)
    sum += rule->weight[g] * pow(rule->point[g][0], i) * pow(rule->point[g][1], j);
  return sum;
}

/* The same exactly: i! j! / (i + j + 2)!. */
static double triangle_integral(int i, int j) {
  return factorial(i) * factorial(j) / factorial(i + j + 2);
}

START_TEST(triangle_rule_integrates_all_monomials_of_its_degree) {
  for (int k = 0; k < N_RULES; k++) {
    const TriangleRule *rule = triangle_rule(rule_sizes[k]);
    ck_assert_ptr_nonnull(rule);
    ck_assert_int_eq(rule->n, rule_sizes[k]);
    for (int i = 0; i <= rule->degree; i++)
      for (int j = 0; i + j <= rule->degree; j++) /* round-off of at most 16 terms below 1/2 */
        ck_assert_double_eq_tol(triangle_sum(rule, i, j), triangle_integral(i, j), 1e-15);
  }
}
END_TEST

START_TEST(triangle_rule_is_not_better_than_it_says) {
  for (int k = 0; k < N_RULES; k++) {
    const TriangleRule *rule = triangle_rule(rule_sizes[k]);
    double worst = 0.0;
    for (int i = 0; i <= rule->degree + 1; i++) {
      int j = rule->degree + 1 - i;
      worst = fmax(worst, fabs(triangle_sum(rule, i, j) - triangle_integral(i, j)));
    }
    ck_assert_double_gt(worst, 1e-8);
  }
}
END_TEST

START_TEST(triangle_rule_has_positive_weights_and_interior_points) {
  for (int k = 0; k < N_RULES; k++) {
    const TriangleRule *rule = triangle_rule(rule_sizes[k]);
    for (int g = 0; g < rule->n; g++) {
      ck_assert_double_gt(rule->weight[g], 0.0);
      ck_assert_double_gt(rule->point[g][0], 0.0);
      ck_assert_double_gt(rule->point[g][1], 0.0);
      ck_assert_double_lt(rule->point[g][0] + rule->point[g][1], 1.0);
    }
  }
}
END_TEST

/* Whether the rule has a point of weight w at barycentric coordinates L1, L2. */
static int rule_has(const TriangleRule *rule, double w, double L1, double L2) {
  for (int g = 0; g < rule->n; g++)
    if (rule->weight[g] == w && fabs(rule->point[g][0] - L1) + fabs(rule->point[g][1] - L2) < 1e-15)
      return 1; /* 1e-15: the third coordinate is 1 minus the others */
  return 0;
}

START_TEST(triangle_rule_is_symmetric_under_all_permutations_of_the_corners) {
  for (int k = 0; k < N_RULES; k++) {
    const TriangleRule *rule = triangle_rule(rule_sizes[k]);
    for (int g = 0; g < rule->n; g++) {
      double L[3] = {1.0 - rule->point[g][0] - rule->point[g][1], rule->point[g][0], rule->point[g][1]};
      for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
          if (i != j) ck_assert(rule_has(rule, rule->weight[g], L[i], L[j]));
    }
  }
}
END_TEST

START_TEST(other_numbers_of_points_have_no_rule) {
  for (int n = -1; n < 40; n++) {
    int known = 0;
    for (int k = 0; k < N_RULES; k++) known = known || rule_sizes[k] == n;
    ck_assert(known == (triangle_rule(n) != 0));
  }
}
END_TEST

START_TEST(gauss_rule_integrates_powers_to_degree_2n_minus_1) {
  for (int n = 1; n <= GAUSS_MAX; n++) {
    double x[GAUSS_MAX], w[GAUSS_MAX];
    gauss_rule(n, x, w);
    for (int k = 0; k <= 2 * n - 1; k++) {
      double sum = 0.0;
      for (int i = 0; i < n; i++) sum += w[i] * pow(x[i], k);
      /* round-off: a power k magnifies the last bit of a point by k, and 64 terms are summed */
      ck_assert_double_eq_tol(sum, 1.0 / (k + 1), 1e-15 * (1 + 0.1 * n));
    }
  }
}
END_TEST

START_TEST(gauss_rule_is_symmetric_rising_and_positive) {
  for (int n = 1; n <= GAUSS_MAX; n++) {
    double x[GAUSS_MAX], w[GAUSS_MAX];
    gauss_rule(n, x, w);
    for (int i = 0; i < n; i++) {
      ck_assert_double_gt(w[i], 0.0);
      ck_assert_double_gt(x[i], i ? x[i - 1] : 0.0);
      ck_assert_double_eq(w[i], w[n - 1 - i]);
      ck_assert_double_eq_tol(x[i] + x[n - 1 - i], 1.0, 2e-16); /* one rounding of 1 - z and of 1 + z */
    }
    ck_assert_double_lt(x[n - 1], 1.0);
  }
}
END_TEST

START_TEST(gauss_rule_agrees_with_the_closed_forms_for_two_and_three_points) {
  double x[3], w[3];
  gauss_rule(2, x, w);
  ck_assert_double_eq_tol(x[0], 0.5 - 0.5 / sqrt(3.0), 1e-16);
  ck_assert_double_eq_tol(w[0], 0.5, 2e-16);
  gauss_rule(3, x, w);
  ck_assert_double_eq_tol(x[0], 0.5 - 0.5 * sqrt(0.6), 1e-16);
  ck_assert_double_eq(x[1], 0.5);
  ck_assert_double_eq_tol(w[0], 5.0 / 18.0, 2e-16);
  ck_assert_double_eq_tol(w[1], 4.0 / 9.0, 2e-16);
}
END_TEST

int main(void) {
  return suite_run("quadrature",
                   (SuiteTests){triangle_rule_integrates_all_monomials_of_its_degree,
                                triangle_rule_is_not_better_than_it_says,
                                triangle_rule_has_positive_weights_and_interior_points,
                                triangle_rule_is_symmetric_under_all_permutations_of_the_corners,
                                other_numbers_of_points_have_no_rule,
                                gauss_rule_integrates_powers_to_degree_2n_minus_1,
                                gauss_rule_is_symmetric_rising_and_positive,
                                gauss_rule_agrees_with_the_closed_forms_for_two_and_three_points, NULL});
}
