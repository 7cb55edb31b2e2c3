/* The way down the tree: every element once and nothing twice, wherever the target and whatever is near. */
#include "base/array.h"
#include "base/vec3.h"
#include "fluid/walk.h"
#include "suite.h"
#include <math.h>

typedef struct {
  Mesh mesh;
  double *x, *q;
} Surface;

/* An ellipsoid with a load that tells one place from another. */
static void surface_new(Surface *surface, int subdivisions, const double axis[3]) {
  Error error;
  ck_assert_int_eq(mesh_sphere(&surface->mesh, subdivisions, NULL, &error), STATUS_OK);
  int n = 3 * surface->mesh.n_nodes;
  ck_assert_int_eq(ARRAY_NEW(&surface->x, n, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&surface->q, n, &error), STATUS_OK);
  for (int i = 0; i < n; i++) {
    surface->x[i] = axis[i % 3] * surface->mesh.X[i];
    surface->q[i] = 1 + surface->mesh.X[i] * surface->mesh.X[i];
  }
}

static void surface_free(Surface *surface) {
  mesh_free(&surface->mesh);
  array_free(surface->x);
  array_free(surface->q);
}

static int holds(const int element[6], int p) {
  for (int k = 0; k < 6; k++) {
    if (element[k] == p) return 1;
  }
  return 0;
}

static void add_blocks(const OseenBlock *blocks, int n, double force[3]) {
  for (int i = 0; i < n * OSEEN_LANES; i++) {
    for (int c = 0; c < 3; c++) force[c] += blocks[i / OSEEN_LANES].f[c][i % OSEEN_LANES];
  }
}

/* The far and the near part for node p, with all elements cut; the forces gathered, to compare with those of
 * all elements but the ones around p. */
static void assert_every_element_once(SurfaceTree *tree, const Surface *surface, int p, WalkCount *count) {
  Gather gather;
  NearElements near;
  double gathered[3] = {0, 0, 0}, expected[3] = {0, 0, 0};
  const TreeLevel *elements = &tree->level[tree->element_level];
  gather_start(&gather, surface->x + 3 * p);
  walk_far(tree, surface->x, surface->q, p, &gather, &near, count);
  for (int i = 0; i < gather.n_listed; i++) add_blocks(gather.listed[i].first, gather.listed[i].n, gathered);
  ck_assert(gather.u[0] == 0); /* the list has not been summed: nothing is missing from it */
  gather_start(&gather, surface->x + 3 * p);
  walk_near(tree, surface->x, surface->q, &near, &gather, count);
  for (int i = 0; i < gather.n_listed; i++) add_blocks(gather.listed[i].first, gather.listed[i].n, gathered);
  ck_assert(gather.u[0] == 0);
  for (int e = 0; e < surface->mesh.n_elements; e++) {
    if (holds(surface->mesh.element[e], p)) continue;
    add_blocks(&elements->points[e * elements->n_blocks], elements->n_blocks, expected);
  }
  /* Forces of pieces differ from those of the element by its quadrature error; a lost piece is 1e-3. */
  for (int c = 0; c < 3; c++) ck_assert_double_eq_tol(gathered[c], expected[c], 2e-5);
}

static void assert_for_many_targets(const Surface *surface, const TreeScheme *scheme, WalkCount *total) {
  SurfaceTree tree;
  Error error;
  *total = (WalkCount){0, 0};
  ck_assert_int_eq(tree_new(&tree, &surface->mesh, scheme, &error), STATUS_OK);
  tree_update(&tree, surface->x, surface->q);
  for (int e = 0; e < surface->mesh.n_elements; e++) tree_cut(&tree, e, surface->x, surface->q);
  for (int p = 0; p < surface->mesh.n_nodes; p += 7) {
    WalkCount count = {0, 0};
    assert_every_element_once(&tree, surface, p, &count);
    total->far += count.far;
    total->near += count.near;
  }
  tree_free(&tree);
}

static const double CAPSULE[3] = {2, 1, 0.5};
static const TreeScheme PLAIN = {.rule_points = 6}, BISECTED = {.rule_points = 6, .reach = 4.2},
                        MOMENTS = {.rule_points = 6, .reach = 4.2, .far = 3.1, .rough = 5e-5};

START_TEST(every_element_is_gathered_once) {
  for (int subdivisions = 0; subdivisions <= 3; subdivisions++) {
    Surface surface;
    WalkCount plain, bisected, moments;
    surface_new(&surface, subdivisions, CAPSULE);
    assert_for_many_targets(&surface, &PLAIN, &plain);
    ck_assert_int_eq(plain.near, 0);
    if (subdivisions > 1) { /* fewer elements are too coarse for the tolerance on pieces */
      assert_for_many_targets(&surface, &BISECTED, &bisected);
      ck_assert_int_gt(bisected.near, 0);
      assert_for_many_targets(&surface, &MOMENTS, &moments);
      ck_assert_int_eq(moments.near, bisected.near);
      if (subdivisions == 3) ck_assert_int_lt(2 * moments.far, bisected.far);
    }
    surface_free(&surface);
  }
}
END_TEST

START_TEST(more_near_elements_than_fit_on_the_list_are_cut_on_the_spot) {
  Surface surface;
  SurfaceTree tree;
  Error error;
  surface_new(&surface, 2, CAPSULE);
  const TreeScheme wide = {.rule_points = 6, .reach = 12};
  ck_assert_int_eq(tree_new(&tree, &surface.mesh, &wide, &error), STATUS_OK);
  tree_update(&tree, surface.x, surface.q);
  Gather gather;
  NearElements near;
  WalkCount count;
  gather_start(&gather, surface.x);
  count = (WalkCount){0, 0};
  walk_far(&tree, surface.x, surface.q, 0, &gather, &near, &count);
  ck_assert_int_eq(near.n, NEAR_LISTED);
  ck_assert_int_gt(count.near, 0);
  tree_free(&tree);
  surface_free(&surface);
}
END_TEST

START_TEST(targets_far_from_a_piece_take_it_whole_and_near_ones_do_not) {
  Surface surface;
  SurfaceTree tree;
  Error error;
  surface_new(&surface, 2, CAPSULE);
  ck_assert_int_eq(tree_new(&tree, &surface.mesh, &BISECTED, &error), STATUS_OK);
  tree_update(&tree, surface.x, surface.q);
  const TreeLevel *elements = &tree.level[tree.element_level];
  for (int p = 0; p < surface.mesh.n_nodes; p += 5) {
    Gather gather;
    NearElements near;
    WalkCount count = {0, 0};
    gather_start(&gather, surface.x + 3 * p);
    walk_far(&tree, surface.x, surface.q, p, &gather, &near, &count);
    int expected = 0;
    for (int e = 0; e < surface.mesh.n_elements; e++) {
      double center[3];
      for (int c = 0; c < 3; c++) center[c] = elements->center[c][e];
      double distance = vec3_distance(center, surface.x + 3 * p);
      expected += !holds(surface.mesh.element[e], p) && distance * distance < elements->reach2[e];
    }
    ck_assert_int_eq(near.n, expected);
  }
  tree_free(&tree);
  surface_free(&surface);
}
END_TEST

START_TEST(running_out_of_memory_leaves_a_tree_that_can_be_freed) {
  Surface surface;
  Error error;
  surface_new(&surface, 2, CAPSULE);
  Status status = STATUS_MEMORY;
  int n = 1;
  for (; status == STATUS_MEMORY && n < 200; n++) {
    SurfaceTree tree;
    array_fail_nth(n);
    status = tree_new(&tree, &surface.mesh, &MOMENTS, &error);
    tree_free(&tree);
  }
  array_fail_nth(0);
  ck_assert_int_eq(status, STATUS_OK);
  ck_assert_int_gt(n, 20);
  surface_free(&surface);
}
END_TEST

int main(void) {
  return suite_run("walk", (SuiteTests){every_element_is_gathered_once,
                                        more_near_elements_than_fit_on_the_list_are_cut_on_the_spot,
                                        targets_far_from_a_piece_take_it_whole_and_near_ones_do_not,
                                        running_out_of_memory_leaves_a_tree_that_can_be_freed, NULL});
}
