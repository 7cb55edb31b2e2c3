/* Pieces of P2 elements: halves are the same surface, and rules on them integrate what they should. */
#include "fluid/piece.h"
#include "mesh/p2.h"
#include "suite.h"
#include <math.h>

/* A curved triangle with a quadratic load. */
static void curved(Piece *piece) {
  for (int k = 0; k < 6; k++) {
    double s = p2_node[k][0], t = p2_node[k][1];
    const double node[PIECE_COMPONENTS] = {
        s + 0.1 * t * t, 2 * t - 0.2 * s * t, 0.3 * s * s - 0.1 * t, 1 + s, s * t, 2 - t * t};
    for (int c = 0; c < PIECE_COMPONENTS; c++) piece->node[k][c] = node[c];
  }
}

static double value(const Piece *piece, int component, double xi, double eta) {
  double N[6], sum = 0;
  p2_values(xi, eta, N);
  for (int k = 0; k < 6; k++) sum += N[k] * piece->node[k][component];
  return sum;
}

/* Sum of the forces and of their moments about the first axis. */
static void total(const Piece *piece, int rule_points, double sum[4]) {
  PieceRule rule;
  OseenBlock blocks[2];
  piece_rule(&rule, rule_points);
  piece_points(piece, &rule, blocks);
  for (int i = 0; i < rule.n_blocks * OSEEN_LANES; i++) {
    const OseenBlock *block = &blocks[i / OSEEN_LANES];
    int lane = i % OSEEN_LANES;
    for (int c = 0; c < 3; c++) sum[c] += block->f[c][lane];
    sum[3] += block->y[1][lane] * block->f[2][lane] - block->y[2][lane] * block->f[1][lane];
  }
}

START_TEST(halves_are_the_same_surface_with_the_same_load) {
  Piece whole, half[2];
  curved(&whole);
  piece_bisect(&whole, &half[0], &half[1]);
  /* The longest edge is 12: the middle is node 4, the opposite corner 0. */
  for (int c = 0; c < 6; c++) {
    const double points[][2] = {{0.2, 0.3}, {0.6, 0.1}, {0, 1}, {0.25, 0.5}};
    for (int i = 0; i < 4; i++) {
      double xi = points[i][0], eta = points[i][1], rest = 1 - xi - eta;
      /* corners (1, 4, 0) and (4, 2, 0) of the halves in the parameters of the whole */
      ck_assert_double_eq_tol(value(&half[0], c, xi, eta), value(&whole, c, rest + xi / 2, xi / 2), 1e-15);
      ck_assert_double_eq_tol(value(&half[1], c, xi, eta), value(&whole, c, rest / 2, rest / 2 + xi), 1e-15);
    }
  }
}
END_TEST

START_TEST(longest_edge_is_cut_whichever_it_is) {
  for (int turn = 0; turn < 3; turn++) {
    Piece whole, turned, half[2];
    curved(&whole);
    for (int k = 0; k < 3; k++) {
      for (int c = 0; c < PIECE_COMPONENTS; c++) {
        turned.node[(k + turn) % 3][c] = whole.node[k][c];
        turned.node[3 + (k + turn) % 3][c] = whole.node[3 + k][c];
      }
    }
    piece_bisect(&turned, &half[0], &half[1]);
    for (int c = 0; c < 6; c++) {
      ck_assert_double_eq(half[0].node[1][c], whole.node[4][c]);
      ck_assert_double_eq(half[1].node[0][c], whole.node[4][c]);
    }
  }
}
END_TEST

START_TEST(forces_of_the_halves_converge_to_those_of_the_whole) {
  Piece whole, half[2];
  double coarse[4] = {0}, fine[4] = {0}, best[4] = {0};
  curved(&whole);
  piece_bisect(&whole, &half[0], &half[1]);
  total(&whole, 6, coarse);
  total(&whole, 16, best);
  for (int i = 0; i < 2; i++) total(&half[i], 6, fine);
  for (int c = 0; c < 4; c++) {
    ck_assert_double_eq_tol(coarse[c], best[c], 2e-4); /* degree 4 on a smooth integrand of size 1 */
    ck_assert_double_eq_tol(fine[c], best[c], 4e-5);
  }
}
END_TEST

START_TEST(places_not_needed_repeat_a_point_without_force) {
  Piece piece;
  PieceRule rule;
  OseenBlock block[2];
  curved(&piece);
  piece_rule(&rule, 12);
  ck_assert_int_eq(rule.n_blocks, 2);
  piece_points(&piece, &rule, block);
  for (int lane = 4; lane < OSEEN_LANES; lane++) {
    for (int c = 0; c < 3; c++) {
      ck_assert_double_eq(block[1].y[c][lane], block[0].y[c][0]);
      ck_assert_double_eq(block[1].f[c][lane], 0);
    }
  }
}
END_TEST

START_TEST(reach_counts_radii_of_gyration) {
  /* Corners (0,0), (3,0), (0,3): points are spread by 3^2/18 in each direction. */
  Piece piece = {0};
  piece.node[1][0] = piece.node[2][1] = 3;
  double centroid[3], reach2 = piece_reach2(&piece, 2, centroid);
  ck_assert_double_eq_tol(reach2, 4 * 2 * 9.0 / 18, 1e-14);
  ck_assert_double_eq_tol(centroid[0], 1, 1e-15);
  ck_assert_double_eq_tol(centroid[1], 1, 1e-15);
}
END_TEST

int main(void) {
  return suite_run("piece_kernel", (SuiteTests){halves_are_the_same_surface_with_the_same_load,
                                                longest_edge_is_cut_whichever_it_is,
                                                forces_of_the_halves_converge_to_those_of_the_whole,
                                                places_not_needed_repeat_a_point_without_force,
                                                reach_counts_radii_of_gyration, NULL});
}
