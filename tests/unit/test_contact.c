/* The thinnest film between two parts of a surface, on shapes whose gap is known and on shapes without one.
 */
#include "mesh/contact.h"

#include "base/array.h"
#include "base/vec3.h"
#include "near_shapes.h"
#include "suite.h"

typedef struct {
  Mesh mesh;
  double *x, edge;
  ContactSearch *search;
} Surface;

static void surface_new(Surface *made, int subdivisions, const MeshRotation *rotation) {
  Error error;
  ck_assert_int_eq(mesh_sphere(&made->mesh, subdivisions, rotation, &error), STATUS_OK);
  ck_assert_int_eq(ARRAY_NEW(&made->x, 3 * (size_t)made->mesh.n_nodes, &error), STATUS_OK);
  ck_assert_int_eq(contact_search_new(&made->search, &made->mesh, &error), STATUS_OK);
  made->edge = mesh_edge_length(&made->mesh, made->mesh.X);
}

static void surface_free(Surface *made) {
  contact_search_free(made->search);
  array_free(made->x);
  mesh_free(&made->mesh);
}

static Contact find(Surface *made, NearShape *shape, double gap) {
  near_shape(shape, gap, &made->mesh, made->x);
  return contact_find(made->search, made->x);
}

START_TEST(smooth_capsules_have_no_contact) {
  static const double axes[][3] = {{1, 1, 1}, {2, 1, 0.5}, {3, 1, 1.0 / 3}, {4, 0.5, 0.5}, {1.2, 1.2, 0.35}};
  Surface made;
  surface_new(&made, 3, NULL);
  for (size_t k = 0; k < sizeof axes / sizeof *axes; k++) {
    for (int i = 0; i < 3 * made.mesh.n_nodes; i++) made.x[i] = axes[k][i % 3] * made.mesh.X[i];
    const Contact contact = contact_find(made.search, made.x);
    ck_assert(isinf(contact.share) && isinf(contact.gap) && !contact.crosses);
    ck_assert_int_eq(contact.node, -1);
  }
  surface_free(&made);
}
END_TEST

START_TEST(wrinkles_are_no_contact) {
  Surface made;
  surface_new(&made, 3, NULL);
  for (int p = 0; p < made.mesh.n_nodes; p++) { /* one wave in five elements, flanks up to 45 degrees steep */
    const double *X = made.mesh.X + 3 * p, height = 1 + 0.12 * sin(8 * X[0]) * cos(8 * X[1]);
    for (int i = 0; i < 3; i++) made.x[3 * p + i] = height * X[i];
  }
  const Contact contact = contact_find(made.search, made.x);
  ck_assert(isinf(contact.share) && !contact.crosses);
  surface_free(&made);
}
END_TEST

/* The thinnest place is at a node of this mesh. */
START_TEST(the_gap_of_a_dimpled_disc_is_that_of_its_middle) {
  static const double gaps[] = {0.1, 0.03, 0.01, 1e-3, 1e-5};
  Surface made;
  surface_new(&made, 3, NULL);
  for (size_t k = 0; k < sizeof gaps / sizeof *gaps; k++) {
    const Contact contact = find(&made, biconcave_disc, gaps[k]);
    ck_assert_double_eq_tol(contact.gap, gaps[k], 1e-5); /* the P2 surface beside it */
    ck_assert_double_lt(vec3_norm(contact.place), 1e-2);
    ck_assert(!contact.crosses);
    const double width = contact.gap / contact.share; /* sqrt(3)/2 of an edge, more or less */
    ck_assert_double_ge(width, 0.75 * made.edge);
    ck_assert_double_le(width, 1.05 * made.edge);
  }
  ck_assert(isinf(find(&made, biconcave_disc, 0.2).share)); /* thicker than an element is wide */
  surface_free(&made);
}
END_TEST

/* Where the middle is no node, the film is seen where a node is: up to 0.3 edges beside it, where the disc is
 * thicker by 2 r^2 = 4e-3. */
START_TEST(turned_meshes_see_the_same_gap_at_their_nodes) {
  for (int turn = 1; turn <= 6; turn++) {
    const MeshRotation rotation = {.axis = {1, 0.3 * turn, -0.7}, .angle = 0.9 * turn};
    Surface made;
    surface_new(&made, 3, &rotation);
    const Contact contact = find(&made, biconcave_disc, 0.02);
    ck_assert_double_ge(contact.gap, 0.02 - 1e-4); /* error of the P2 surface */
    ck_assert_double_le(contact.gap, 0.02 + 4e-3);
    ck_assert(!contact.crosses);
    surface_free(&made);
  }
}
END_TEST

START_TEST(tips_that_meet_outside_are_found) {
  Surface made;
  surface_new(&made, 3, NULL);
  const Contact contact = find(&made, bent_rod, 0.01);
  ck_assert_double_eq_tol(contact.gap, 0.01, 1e-6);
  ck_assert_double_eq_tol(contact.place[2], 1.6, 1e-3);
  ck_assert(!contact.crosses);
  surface_free(&made);
}
END_TEST

START_TEST(a_surface_that_crosses_itself_is_told_from_one_that_does_not) {
  static const double gaps[] = {1e-3, 0.01, 0.05};
  static NearShape *const shapes[] = {biconcave_disc, bent_rod};
  for (int subdivisions = 2; subdivisions <= 3; subdivisions++) {
    Surface made;
    surface_new(&made, subdivisions, NULL);
    for (size_t shape = 0; shape < 2; shape++)
      for (size_t k = 0; k < sizeof gaps / sizeof *gaps; k++) {
        ck_assert(!find(&made, shapes[shape], gaps[k]).crosses);
        ck_assert(find(&made, shapes[shape], -gaps[k]).crosses);
      }
    surface_free(&made);
  }
}
END_TEST

START_TEST(running_out_of_memory_is_reported) {
  Mesh mesh;
  Error error;
  ContactSearch *search;
  ck_assert_int_eq(mesh_sphere(&mesh, 1, NULL, &error), STATUS_OK);
  Status status = STATUS_MEMORY;
  int n = 1;
  for (; status == STATUS_MEMORY && n < 100; n++) {
    array_fail_nth(n);
    status = contact_search_new(&search, &mesh, &error);
  }
  array_fail_nth(0);
  ck_assert_int_eq(status, STATUS_OK);
  ck_assert_int_gt(n, 4);
  contact_search_free(search);
  mesh_free(&mesh);
}
END_TEST

int main(void) {
  return suite_run("contact", (SuiteTests){smooth_capsules_have_no_contact, wrinkles_are_no_contact,
                                           the_gap_of_a_dimpled_disc_is_that_of_its_middle,
                                           turned_meshes_see_the_same_gap_at_their_nodes,
                                           tips_that_meet_outside_are_found,
                                           a_surface_that_crosses_itself_is_told_from_one_that_does_not,
                                           running_out_of_memory_is_reported, NULL});
}
