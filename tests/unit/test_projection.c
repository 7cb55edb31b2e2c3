/* A surface cut into flat pieces and seen from one side. */
#include "observe/projection.h"

#include "base/array.h"
#include "base/vec3.h"
#include "suite.h"
#include <math.h>

static const double origin[3] = {0, 0, 0};
static const double oblique[3] = {1, -2, 0.5}, upward[3] = {0, 0, 1};

static Mesh sphere(int subdivisions) {
  Mesh mesh;
  Error error;
  ck_assert_int_eq(mesh_sphere(&mesh, subdivisions, NULL, &error), STATUS_OK);
  return mesh;
}

static Projection seen_from(const double toward[3]) {
  Projection projection;
  Error error;
  ck_assert_int_eq(projection_make(&projection, toward, upward, &error), STATUS_OK);
  return projection;
}

static Piece *pieces_of(const Mesh *mesh, const double *field, int cuts, size_t *count) {
  Piece *pieces;
  Error error;
  const Projection projection = seen_from(oblique);
  ck_assert_int_eq(projection_pieces(&projection, mesh, mesh->X, field, origin, cuts, &pieces, count, &error),
                   STATUS_OK);
  return pieces;
}

/* Twice the signed area in the picture. */
static double twice_area(const Piece *piece) {
  double a[2], b[2];
  for (int i = 0; i < 2; i++) {
    a[i] = piece->corner[1][i] - piece->corner[0][i];
    b[i] = piece->corner[2][i] - piece->corner[0][i];
  }
  return a[0] * b[1] - a[1] * b[0];
}

static double visible_area(const Mesh *mesh, int cuts) {
  size_t count;
  Piece *pieces = pieces_of(mesh, NULL, cuts, &count);
  double area = 0;
  for (size_t k = 0; k < count; k++) area += twice_area(&pieces[k]) / 2;
  array_free(pieces);
  return area;
}

START_TEST(the_axes_of_a_view_are_orthonormal_and_right_handed) {
  const Projection projection = seen_from(oblique);
  double cross[3];
  vec3_cross(projection.right, projection.up, cross);
  ck_assert_double_le(vec3_distance(cross, projection.toward), 1e-15); /* round-off of unit vectors */
  ck_assert_double_le(fabs(vec3_norm(projection.right) - 1), 1e-15);
  ck_assert_double_gt(projection.up[2], 0);
  /* seen from -y with z up, x points to the right */
  const Projection shear_plane = seen_from((const double[]){0, -3, 0});
  ck_assert(shear_plane.right[0] == 1 && shear_plane.up[2] == 1);
}
END_TEST

START_TEST(a_sphere_looks_like_a_disc) {
  Mesh mesh = sphere(2);
  ck_assert_double_le(fabs(visible_area(&mesh, 4) / acos(-1) - 1), 2e-3); /* flat pieces of 1/16 radian */
  mesh_free(&mesh);
}
END_TEST

/* On straight-sided elements the pieces tile the element exactly, whatever their number. */
START_TEST(pieces_tile_their_element) {
  Mesh mesh = sphere(1);
  for (int e = 0; e < mesh.n_elements; e++)
    for (int side = 0; side < 3; side++)
      for (int i = 0; i < 3; i++)
        mesh.X[3 * mesh.element[e][3 + side] + i] =
            0.5 * (mesh.X[3 * mesh.element[e][side] + i] + mesh.X[3 * mesh.element[e][(side + 1) % 3] + i]);
  const double whole = visible_area(&mesh, 1);
  for (int cuts = 2; cuts <= 5; cuts++) {
    size_t count;
    array_free(pieces_of(&mesh, NULL, cuts, &count));
    ck_assert_uint_eq(count % (size_t)(cuts * cuts), 0);
    ck_assert_double_le(fabs(visible_area(&mesh, cuts) - whole), 1e-13); /* round-off of some 1000 areas */
  }
  mesh_free(&mesh);
}
END_TEST

START_TEST(pieces_come_from_far_to_near_and_face_the_eye) {
  Mesh mesh = sphere(2);
  size_t count;
  Piece *pieces = pieces_of(&mesh, NULL, 3, &count);
  ck_assert_uint_gt(count, 0);
  for (size_t k = 0; k < count; k++) {
    if (k > 0) ck_assert_double_ge(pieces[k].depth, pieces[k - 1].depth);
    ck_assert_double_gt(twice_area(&pieces[k]), 0);
    ck_assert(pieces[k].light >= 0 && pieces[k].light <= 1 + 1e-15);
  }
  array_free(pieces);
  mesh_free(&mesh);
}
END_TEST

/* The field x . toward is interpolated like the positions, so its value is the depth. */
START_TEST(the_field_is_interpolated_with_the_surface) {
  Mesh mesh = sphere(1);
  Error error;
  const Projection projection = seen_from(oblique);
  double *field;
  ck_assert_int_eq(ARRAY_NEW(&field, mesh.n_nodes, &error), STATUS_OK);
  for (int p = 0; p < mesh.n_nodes; p++) field[p] = vec3_dot(mesh.X + 3 * p, projection.toward);
  size_t count;
  Piece *pieces = pieces_of(&mesh, field, 3, &count);
  for (size_t k = 0; k < count; k++) ck_assert_double_le(fabs(pieces[k].value - pieces[k].depth), 1e-14);
  array_free(pieces);
  array_free(field);
  mesh_free(&mesh);
}
END_TEST

START_TEST(a_view_without_direction_is_refused) {
  Projection projection;
  Error error;
  ck_assert_int_eq(projection_make(&projection, origin, upward, &error), STATUS_INPUT);
  ck_assert_int_eq(projection_make(&projection, upward, upward, &error), STATUS_INPUT);
  ck_assert_int_eq(projection_make(&projection, (const double[]){NAN, 0, 0}, upward, &error), STATUS_INPUT);
}
END_TEST

int main(void) {
  return suite_run("projection", (SuiteTests){the_axes_of_a_view_are_orthonormal_and_right_handed,
                                              a_sphere_looks_like_a_disc, pieces_tile_their_element,
                                              pieces_come_from_far_to_near_and_face_the_eye,
                                              the_field_is_interpolated_with_the_surface,
                                              a_view_without_direction_is_refused, NULL});
}
