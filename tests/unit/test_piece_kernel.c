/* Pieces of P2 elements: halves are the same surface, and rules on them integrate what they should. */
#include "fluid/piece.h"
#include "mesh/p2.h"
#include "mesh/symmetry.h"
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
      double xi = points[i][0], eta = points[i][1];
      /* corners (0, 1, 4) and (0, 4, 2) of the halves in the parameters of the whole */
      ck_assert_double_eq_tol(value(&half[0], c, xi, eta), value(&whole, c, xi + eta / 2, eta / 2), 1e-15);
      ck_assert_double_eq_tol(value(&half[1], c, xi, eta), value(&whole, c, xi / 2, xi / 2 + eta), 1e-15);
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
      ck_assert_double_eq(half[0].node[0][c], whole.node[0][c]);
      ck_assert_double_eq(half[0].node[2][c], whole.node[4][c]);
      ck_assert_double_eq(half[1].node[0][c], whole.node[0][c]);
      ck_assert_double_eq(half[1].node[1][c], whole.node[4][c]);
    }
  }
}
END_TEST

/* The flat triangle with these corners. */
static void flat(const double corner[3][2], Piece *piece) {
  *piece = (Piece){0};
  for (int k = 0; k < 3; k++) {
    for (int c = 0; c < 2; c++) {
      piece->node[k][c] = corner[k][c];
      piece->node[3 + k][c] = 0.5 * (corner[k][c] + corner[(k + 1) % 3][c]);
    }
  }
}

START_TEST(edges_that_are_equal_but_for_round_off_leave_the_cut_to_the_base) {
  /* The base of two sides alike, of a side and base alike, and of three: each moved a little either way. */
  const double shapes[][3][2] = {
      {{0, 3}, {-1, 0}, {1, 0}}, {{0, 0}, {2, 0}, {0.25, 1}}, {{0, 0}, {2, 0}, {1, 1.7320508}}};
  for (int shape = 0; shape < 3; shape++) {
    for (int sign = -1; sign <= 1; sign += 2) {
      Piece whole, half[2];
      flat(shapes[shape], &whole);
      if (shape == 1)
        whole.node[2][1] = sqrt(4 - 1.75 * 1.75); /* as far from corner 1 as that from corner 0 */
      whole.node[1][0] *= 1 + sign * 1e-9;
      piece_bisect(&whole, &half[0], &half[1]);
      for (int c = 0; c < 2; c++) ck_assert_double_eq(half[0].node[2][c], whole.node[4][c]);
    }
  }
}
END_TEST

START_TEST(a_needle_is_cut_across) {
  const double needle[3][2] = {{0, 20}, {-0.5, 0}, {0.5, 0}};
  Piece whole, half[2];
  flat(needle, &whole);
  piece_bisect(&whole, &half[0], &half[1]);
  for (int c = 0; c < 2; c++) ck_assert_double_eq(half[0].node[2][c], whole.node[3][c]);
}
END_TEST

/* The mirror image: corner 0 stays, 1 and 2 change places. */
static void mirror(const Piece *piece, Piece *image) {
  const int from[6] = {0, 2, 1, 5, 4, 3};
  for (int k = 0; k < 6; k++) {
    for (int c = 0; c < PIECE_COMPONENTS; c++)
      image->node[k][c] = (c == 1 || c == 4 ? -1 : 1) * piece->node[from[k]][c];
  }
}

START_TEST(halves_of_the_mirror_image_are_the_mirror_images_of_the_halves) {
  Piece piece[1 << 5], image[1 << 5];
  curved(&piece[0]);
  mirror(&piece[0], &image[0]);
  for (int depth = 0; depth < 4; depth++) { /* in place, from the last one on */
    for (int i = (1 << depth) - 1; i >= 0; i--) {
      const Piece p = piece[i], q = image[i];
      piece_bisect(&p, &piece[2 * i], &piece[2 * i + 1]);
      piece_bisect(&q, &image[2 * i + 1], &image[2 * i]);
    }
  }
  for (int i = 0; i < 1 << 4; i++) {
    Piece expected;
    mirror(&piece[i], &expected);
    for (int k = 0; k < 6; k++) {
      for (int c = 0; c < PIECE_COMPONENTS; c++)
        ck_assert_double_eq(image[i].node[k][c], expected.node[k][c]);
    }
  }
}
END_TEST

START_TEST(elements_are_turned_alike_whatever_their_numbers_and_on_all_their_images) {
  Mesh mesh;
  Symmetry symmetry;
  Error error;
  ck_assert_int_eq(mesh_sphere(&mesh, 2, NULL, &error), STATUS_OK);
  ck_assert_int_eq(symmetry_find(&symmetry, &mesh, mesh.X, NULL, &error), STATUS_OK);
  ck_assert_int_eq(symmetry.n_operations, 8);
  for (int e = 0; e < mesh.n_elements; e++) {
    const int *node = mesh.element[e], next[6] = {node[1], node[2], node[0], node[4], node[5], node[3]};
    int turned[6], again[6], image[6];
    piece_turn(node, mesh.X, turned);
    piece_turn(next, mesh.X, again);
    ck_assert_mem_eq(turned, again, sizeof turned);
    for (int s = 0; s < symmetry.n_operations; s++) {
      const SymmetryOperation *operation = &symmetry.operation[s];
      piece_turn(mesh.element[operation->element[e]], mesh.X, image);
      ck_assert_int_eq(image[0], operation->node[turned[0]]);
      ck_assert_int_eq(image[4], operation->node[turned[4]]);
    }
  }
  symmetry_free(&symmetry);
  mesh_free(&mesh);
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
  return suite_run(
      "piece_kernel",
      (SuiteTests){halves_are_the_same_surface_with_the_same_load, longest_edge_is_cut_whichever_it_is,
                   edges_that_are_equal_but_for_round_off_leave_the_cut_to_the_base,
                   halves_of_the_mirror_image_are_the_mirror_images_of_the_halves, a_needle_is_cut_across,
                   elements_are_turned_alike_whatever_their_numbers_and_on_all_their_images,
                   forces_of_the_halves_converge_to_those_of_the_whole,
                   places_not_needed_repeat_a_point_without_force, reach_counts_radii_of_gyration, NULL});
}
