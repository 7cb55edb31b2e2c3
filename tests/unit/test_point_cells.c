/* Points near a place are found by cells as by a look at all of them. */
#include "membrane/point_cells.h"

#include "base/array.h"
#include "random.h"
#include "suite.h"
#include <stdbool.h>
#include <stdio.h>

enum { N = 500 };

static void scatter(uint64_t *seed, const double extent[3], double X[N][3]) {
  for (int i = 0; i < N; i++)
    for (int c = 0; c < 3; c++) X[i][c] = extent[c] * random_uniform(seed);
}

static bool is_near(const double a[3], const double b[3], double reach) {
  double r2 = 0;
  for (int c = 0; c < 3; c++) r2 += (a[c] - b[c]) * (a[c] - b[c]);
  return r2 <= reach * reach;
}

/* How often each point is in the runs around a place; returns the number of all. */
static int count(const PointCells *cells, const double place[3], int times[N]) {
  PointRun run[POINT_RUNS];
  int all = 0;
  for (int i = 0; i < N; i++) times[i] = 0;
  const int n = point_cells_near(cells, place, run);
  ck_assert_int_le(n, POINT_RUNS);
  for (int r = 0; r < n; r++)
    for (int k = run[r].begin; k < run[r].end; k++, all++) times[cells->point[k]]++;
  return all;
}

/* In a cube, on a flat and on a thin piece, around places in it and off it, with reaches from far below the
 * distance of points to beyond all of them. */
START_TEST(every_point_within_reach_is_found_once) {
  static const double extents[3][3] = {{2, 2, 2}, {2, 1e-9, 2}, {0, 0, 3}};
  static const double reaches[] = {1e-4, 0.05, 0.4, 10};
  uint64_t seed = 20261122;
  printf("seed %llu\n", (unsigned long long)seed);
  for (int e = 0; e < 3; e++)
    for (int r = 0; r < 4; r++) {
      double X[N][3];
      int times[N];
      PointCells cells;
      Error error;
      scatter(&seed, extents[e], X);
      ck_assert_int_eq(point_cells_new(&cells, N, X[0], reaches[r], &error), STATUS_OK);
      for (int p = 0; p < 200; p++) {
        double place[3];
        for (int c = 0; c < 3; c++) place[c] = p < 100 ? X[p][c] : 3 * random_uniform(&seed);
        count(&cells, place, times);
        int wrong = 0;
        for (int i = 0; i < N; i++)
          wrong += times[i] > 1 || (times[i] == 0 && is_near(X[i], place, reaches[r]));
        ck_assert_int_eq(wrong, 0);
      }
      point_cells_free(&cells);
    }
}
END_TEST

/* There are no more than about N cells, of sides 4 / N^(1/3) = 0.5: a place sees (3 * 0.5 / 4)^3 = 5 % of the
 * cube. */
START_TEST(few_others_are_looked_at) {
  static const double extent[3] = {2, 2, 2};
  double X[N][3], middle[3] = {0, 0, 0};
  int times[N];
  uint64_t seed = 7;
  PointCells cells;
  Error error;
  scatter(&seed, extent, X);
  ck_assert_int_eq(point_cells_new(&cells, N, X[0], 0.01, &error), STATUS_OK);
  ck_assert_int_lt(count(&cells, middle, times), N / 8);
  point_cells_free(&cells);
}
END_TEST

START_TEST(without_memory_nothing_is_left) {
  const double X[3] = {0, 0, 0};
  for (long n = 1; n <= 2; n++) {
    PointCells cells;
    Error error;
    array_fail_nth(n);
    ck_assert_int_eq(point_cells_new(&cells, 1, X, 1, &error), STATUS_MEMORY);
    array_fail_nth(0);
    ck_assert_ptr_null(cells.start);
  }
}
END_TEST

int main(void) {
  return suite_run("point_cells",
                   (SuiteTests){every_point_within_reach_is_found_once, few_others_are_looked_at,
                                without_memory_nothing_is_left, NULL});
}
