/* Parameters that vary over the membrane: the values that elements get, what is refused, and that a law sees
 * each element's own. */
#include "laws/field.h"

#include "base/array.h"
#include "base/file.h"
#include "scratch.h"
#include "shell.h"
#include "suite.h"

static const mlaw_param TENSION = {.name = "Y", .unit = "N/m", .about = "", .dim = {1, 0, -2}};

static Mesh sphere(int subdivisions) {
  Mesh mesh;
  Error error;
  ck_assert_int_eq(mesh_sphere(&mesh, subdivisions, NULL, &error), STATUS_OK);
  return mesh;
}

static FieldPlace place_on(const Mesh *mesh) {
  return (FieldPlace){.mesh = mesh, .P = {0, 1, 0}};
}

static Status sample(const SceneField *field, const Mesh *mesh, double *value, Error *error) {
  const FieldPlace place = place_on(mesh);
  return field_sample(field, &TENSION, &NO_SCALES, &place, value, error);
}

static SceneField spot(double radius, double inside, double outside) {
  return (SceneField){.kind = FIELD_AROUND,
                      .around_P = true,
                      .radius = radius,
                      .inside = {.value = inside},
                      .outside = {.value = outside}};
}

static SceneField weibull(double mean, double modulus, long long seed, double correlation) {
  return (SceneField){.kind = FIELD_WEIBULL,
                      .mean = {.value = mean},
                      .scale = {.value = NAN},
                      .modulus = modulus,
                      .seed = seed,
                      .correlation = correlation};
}

START_TEST(a_spot_covers_the_cap_that_it_should) {
  Mesh mesh = sphere(4);
  double *value = zeros(mesh.n_elements);
  const SceneField field = spot(0.5, 3, 7);
  Error error;
  ck_assert_int_eq(sample(&field, &mesh, value, &error), STATUS_OK);
  /* All points of the sphere at a distance up to r from one of them: a cap of area pi r^2.  The edge of the
   * cap cuts elements of size 0.07, which adds up to a few percent of its area. */
  const double share = (7 - field_mean(value, &mesh)) / 4;
  ck_assert_double_eq_tol(share, 0.25 * 0.5 * 0.5, 0.003);
  for (int e = 0; e < mesh.n_elements; e++) {
    double nearest = 2, farthest = 0;
    for (int k = 0; k < 6; k++) {
      const double *X = &mesh.X[3 * mesh.element[e][k]];
      const double distance = sqrt(X[0] * X[0] + (X[1] - 1) * (X[1] - 1) + X[2] * X[2]);
      nearest = fmin(nearest, distance);
      farthest = fmax(farthest, distance);
    }
    if (farthest < 0.5) ck_assert_double_eq(value[e], 3);
    if (nearest > 0.5) ck_assert_double_eq(value[e], 7);
  }
  free(value);
  mesh_free(&mesh);
}
END_TEST

START_TEST(a_file_gives_its_numbers_in_order_and_says_what_is_wrong_with_it) {
  static const struct {
    const char *text, *message;
  } bad[] = {{"1 2 3 # 4\n", "expected 20 numbers, one for each element, found 3"},
             {"1 2\n3 N/m\n", ":2: expected a number, found `N/m`"},
             {"1 2\n\n3 nan\n", ":3: expected a number, found `nan`"}};
  Mesh mesh = sphere(0);
  double value[20];
  Error error;
  SceneField field = {
      .kind = FIELD_FILE, .file = text_copy("strengths.txt", &error), .times = {.value = 0.5}};
  const char *path = scratch_path("strengths.txt");
  const char good[] = "# twenty\n0 1 2 3 4, 5, 6 7 8 9 # a half\n\t10 11 12 13 14\r\n15 16 17 18 1.9e1";
  ck_assert_int_eq(file_write(path, good, sizeof good - 1, &error), STATUS_OK);
  ck_assert_int_eq(field_pin(&field, scratch_folder, &error), STATUS_OK);
  ck_assert(field.has_hash);
  ck_assert_int_eq(sample(&field, &mesh, value, &error), STATUS_OK);
  for (int e = 0; e < 20; e++) ck_assert_double_eq(value[e], 0.5 * e);

  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    ck_assert_int_eq(file_write(path, bad[i].text, strlen(bad[i].text), &error), STATUS_OK);
    ck_assert_int_eq(sample(&field, &mesh, value, &error), STATUS_INPUT);
    ck_assert_msg(strstr(error.text, bad[i].message), "%s", error.text);
  }
  ck_assert_int_eq(field_pin(&field, scratch_folder, &error), STATUS_INPUT); /* pinned to other content */
  ck_assert_msg(strstr(error.text, "expected the content with hash"), "%s", error.text);
  remove(path);
  ck_assert_int_eq(field_pin(&field, scratch_folder, &error), STATUS_INPUT);
  ck_assert_msg(strstr(error.text, "expected a file that can be read"), "%s", error.text);
  array_free(field.file);
  mesh_free(&mesh);
}
END_TEST

/* Mean of a Weibull distribution of modulus 8: deviation 0.148 of the mean; the mean over 1280 independent
 * elements is off by 0.148/sqrt(1280) = 0.4 %; four of these are allowed. */
START_TEST(scatter_has_the_mean_that_is_asked_for) {
  Mesh mesh = sphere(3);
  double *value = zeros(mesh.n_elements);
  Error error;
  const SceneField field = weibull(2, 8, 42, 0);
  ck_assert_int_eq(sample(&field, &mesh, value, &error), STATUS_OK);
  ck_assert_msg(fabs(field_mean(value, &mesh) / 2 - 1) < 0.017, "mean %g, seed 42", field_mean(value, &mesh));
  free(value);
  mesh_free(&mesh);
}
END_TEST

/* An element of the coarse mesh holds four of the fine one, whose centres lie within its edge of 0.28: with a
 * correlation over 3 the score differs by about 0.28/3. */
START_TEST(correlated_scatter_is_the_same_field_on_every_mesh) {
  Mesh coarse = sphere(2), fine = sphere(3);
  double *a = zeros(coarse.n_elements), *b = zeros(fine.n_elements);
  Error error;
  const SceneField field = weibull(1, 8, 5, 3);
  ck_assert_int_eq(sample(&field, &coarse, a, &error), STATUS_OK);
  ck_assert_int_eq(sample(&field, &fine, b, &error), STATUS_OK);
  ck_assert_double_eq_tol(field_mean(a, &coarse), field_mean(b, &fine), 2e-3);
  double least[2] = {9, 9}, most[2] = {0, 0};
  for (int e = 0; e < coarse.n_elements; e++) least[0] = fmin(least[0], a[e]), most[0] = fmax(most[0], a[e]);
  for (int e = 0; e < fine.n_elements; e++) least[1] = fmin(least[1], b[e]), most[1] = fmax(most[1], b[e]);
  ck_assert_double_eq_tol(least[0], least[1], 0.02);
  ck_assert_double_eq_tol(most[0], most[1], 0.02);
  free(a);
  free(b);
  mesh_free(&coarse);
  mesh_free(&fine);
}
END_TEST

/* ---- Materials ---- */

static Status build(Material *material, SceneField *field, const Mesh *mesh, Error *error) {
  const LawSearch search = test_search();
  const FieldPlace place = place_on(mesh);
  SceneParameter parameters[] = {number("Y_D", Y_D), number("Y_C", Y_C)};
  parameters[1].field = field;
  Scene scene = {0};
  scene.membrane.elastic = scene_law("neo_hookean", NULL, 0);
  scene.membrane.damage = scene_law("marigo", parameters, 2);
  scene.membrane.d_max = 1;
  return material_new(material, &scene, &search, &NO_SCALES, mesh ? &place : NULL, NULL, error);
}

START_TEST(a_value_out_of_range_is_named_with_its_element) {
  Mesh mesh = sphere(1);
  Material material;
  Error error;
  SceneField field = spot(0.4, -0.5, 1);
  ck_assert_int_eq(build(&material, &field, &mesh, &error), STATUS_INPUT);
  ck_assert_msg(strstr(error.text, "scene.yaml:7:20: parameter Y_C of law marigo: element "), "%s",
                error.text);
  ck_assert_msg(strstr(error.text, ": expected at least 0, found -0.5"), "%s", error.text);
  ck_assert_int_eq(build(&material, &field, NULL, &error), STATUS_INPUT);
  ck_assert_msg(strstr(error.text, "expected a number where there is no membrane"), "%s", error.text);
  mesh_free(&mesh);
}
END_TEST

/* Material of an energy law alone, with parameter NAME from a spot around P. */
static Status build_elastic(const char *law, const char *name, double inside, double outside, Error *error) {
  Mesh mesh = sphere(1);
  const LawSearch search = test_search();
  const FieldPlace place = place_on(&mesh);
  Material material;
  SceneField field = spot(0.6, inside, outside);
  SceneParameter parameters[] = {number(name, outside)};
  parameters[0].field = &field;
  Scene scene = {0};
  scene.membrane.elastic = scene_law(law, parameters, 1);
  const Status status = material_new(&material, &scene, &search, &NO_SCALES, &place, NULL, error);
  if (status == STATUS_OK) material_free(&material);
  mesh_free(&mesh);
  return status;
}

START_TEST(a_value_that_the_law_does_not_take_is_named_with_its_element) {
  Error error;
  ck_assert_int_eq(build_elastic("yeoh", "c_2", -0.4, 0, &error), STATUS_INPUT);
  ck_assert_msg(strstr(error.text, "element ") && strstr(error.text, "law yeoh refuses its parameters: "),
                "%s", error.text);
  ck_assert_int_eq(build_elastic(BROKEN "/negative_modulus.so", "G_s", -0.5, 1, &error), STATUS_INPUT);
  ck_assert_msg(strstr(error.text, "element ") &&
                    strstr(error.text, "expected positive moduli at rest, found G_s = -0.5"),
                "%s", error.text);
}
END_TEST

START_TEST(a_law_with_more_parameters_than_can_vary_is_refused) {
  Error error;
  ck_assert_int_eq(build_elastic(BROKEN "/too_many.so", "G_s", 0.5, 1, &error), STATUS_INPUT);
  ck_assert_msg(strstr(error.text, "scene.yaml:5:8: law too_many: expected at most 64 parameters where one "
                                   "varies, found 65"),
                "%s", error.text);
}
END_TEST

static void expect_no_distribution(const SceneField *field, const char *words) {
  Mesh mesh = sphere(0);
  double value[20];
  Error error = {.text = "nothing"};
  ck_assert_int_eq(sample(field, &mesh, value, &error), STATUS_INPUT);
  ck_assert_msg(strstr(error.text, words) != NULL, "expected `%s` in `%s`", words, error.text);
  mesh_free(&mesh);
}

START_TEST(numbers_that_make_no_distribution_are_refused) {
  SceneField field = weibull(0, 8, 1, 0);
  expect_no_distribution(&field, "expected a mean above 0");
  field.mean.value = NAN;
  field.scale.value = -1;
  expect_no_distribution(&field, "expected a scale above 0");
  field = (SceneField){.kind = FIELD_UNIFORM, .from = {.value = 2}, .to = {.value = 1}};
  expect_no_distribution(&field, "expected `from` not above `to`");
  field = (SceneField){.kind = FIELD_NORMAL, .mean = {.value = 1}, .deviation = {.value = -1}};
  expect_no_distribution(&field, "expected a deviation of at least 0");
  field = (SceneField){.kind = FIELD_LOG_NORMAL, .mean = {.value = 0}, .deviation = {.value = 1}};
  expect_no_distribution(&field, "expected a mean above 0");
}
END_TEST

START_TEST(a_field_that_is_the_same_everywhere_is_a_number) {
  Mesh mesh = sphere(1);
  Material material;
  Error error;
  SceneField field = spot(0.5, 0.3, 0.3);
  ck_assert_int_eq(build(&material, &field, &mesh, &error), STATUS_OK);
  ck_assert(!material.damage_values.varies);
  ck_assert_ptr_null(material.damage_values.element[1]);
  ck_assert_double_eq(material.damage_values.value[1], 0.3);
  ck_assert_int_eq(material.damage_field[1].inc, 0);
  material_free(&material);
  mesh_free(&mesh);
}
END_TEST

/* A shell of which the elements of a spot around P have another Y_C. */
static void open_spotted(Shell *shell, double inside, const double gradient[3][3]) {
  Error error;
  SceneField field = spot(0.4, inside, Y_C);
  *shell = (Shell){.mesh = sphere(2)};
  const Status status = build(&shell->material, &field, &shell->mesh, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  shell->n = 3 * shell->mesh.n_nodes;
  if (gradient) {
    ck_assert_int_eq(symmetry_find(&shell->symmetry, &shell->mesh, shell->mesh.X, gradient, &error),
                     STATUS_OK);
    ck_assert_int_eq(
        symmetry_keep_field(&shell->symmetry, &shell->mesh, shell->material.damage_values.element[1], &error),
        STATUS_OK);
    material_keep_elements(&shell->material, shell->symmetry.elements.representative,
                           shell->symmetry.elements.n);
  }
  ck_assert_int_eq(membrane_new(&shell->membrane, &shell->mesh, gradient ? &shell->symmetry : NULL,
                                &shell->material, (MembraneMethod){.solver = MASS_PCG}, &error),
                   STATUS_OK);
}

static bool is_inside(const Shell *shell, int k) {
  return shell->material.damage_values.element[1][k % (membrane_points(shell->membrane) / 6)] != Y_C;
}

/* Every point has the damage of a uniform membrane with the strength of its element, to the last bit. */
START_TEST(every_element_has_the_damage_of_its_own_strength) {
  Shell uniform, weak, spotted;
  SceneParameter strength[] = {number("Y_D", Y_D), number("Y_C", 0.7)};
  shell_open_damaged(&uniform, 2);
  shell_open_with(&weak, 2, scene_law("neo_hookean", NULL, 0), scene_law("marigo", strength, 2), MASS_PCG);
  open_spotted(&spotted, 0.7, NULL);
  double *x = zeros(uniform.n), *R = zeros(uniform.n);
  shell_crumple(&uniform, 1.2, 0.02, 4, x);
  must_force(&uniform, x, R);
  must_force(&weak, x, R);
  must_force(&spotted, x, R);
  const double *strong_d = membrane_trial(uniform.membrane)->d, *weak_d = membrane_trial(weak.membrane)->d;
  const double *d = membrane_trial(spotted.membrane)->d;
  int inside = 0, damaged = 0;
  for (int k = 0; k < membrane_points(spotted.membrane); k++) {
    inside += is_inside(&spotted, k);
    damaged += d[k] > 0;
    ck_assert_double_eq(d[k], is_inside(&spotted, k) ? weak_d[k] : strong_d[k]);
  }
  ck_assert_int_gt(inside, 0);
  ck_assert_int_gt(damaged, 100);
  free(x);
  free(R);
  shell_close(&uniform);
  shell_close(&weak);
  shell_close(&spotted);
}
END_TEST

/* Simple shear has four symmetries; the half turn about the vorticity axis keeps a spot around P. */
START_TEST(a_spot_around_P_keeps_the_half_turn_and_gives_the_same_force_with_it) {
  static const double SHEAR[3][3] = {{0, 0, 1}, {0, 0, 0}, {0, 0, 0}};
  const double F[3][3] = {{1.4, 0, 0.3}, {0, 1.3, 0}, {0.1, 0, 1.1}}; /* commutes with the half turn */
  Shell whole, half;
  open_spotted(&whole, 0.7, NULL);
  open_spotted(&half, 0.7, SHEAR);
  ck_assert_int_eq(half.symmetry.n_operations, 2);
  ck_assert_double_eq(half.symmetry.operation[1].sign[1], 1);
  ck_assert_int_eq(2 * half.symmetry.elements.n, half.mesh.n_elements);
  double *x = zeros(whole.n), *R = zeros(whole.n), *R_half = zeros(whole.n);
  shell_map(&whole, F, x);
  must_force(&whole, x, R);
  must_force(&half, x, R_half);
  for (int i = 0; i < whole.n; i++) ck_assert_double_eq_tol(R_half[i], R[i], 1e-13);
  free(x);
  free(R);
  free(R_half);
  shell_close(&whole);
  shell_close(&half);
}
END_TEST

START_TEST(moduli_must_be_those_of_a_stable_membrane_in_every_element) {
  Mesh mesh = sphere(1);
  const LawSearch search = test_search();
  const FieldPlace place = place_on(&mesh);
  Material material;
  Error error;
  SceneField field = spot(0.6, 3, 1);
  SceneParameter parameters[] = {number("G_s", 1)};
  parameters[0].field = &field;
  Scene scene = {0};
  scene.membrane.elastic = scene_law("neo_hookean", parameters, 1);
  ck_assert_int_eq(material_new(&material, &scene, &search, &NO_SCALES, &place, NULL, &error), STATUS_OK);
  ck_assert(material.elastic_values.varies);
  ck_assert_double_eq_tol(material.shear_modulus, field_mean(material.elastic_values.element[0], &mesh),
                          1e-14);
  ck_assert_double_eq_tol(material.dilatation_modulus, 3 * material.shear_modulus, 1e-9);
  material_free(&material);
  mesh_free(&mesh);
}
END_TEST

START_TEST(set_up_survives_every_failing_allocation) {
  Mesh mesh = sphere(1);
  SceneField field = weibull(2, 8, 1, 0.2);
  Status status = STATUS_MEMORY;
  for (long n = 1; status == STATUS_MEMORY; n++) {
    Material material;
    Error error;
    array_fail_nth(n);
    status = build(&material, &field, &mesh, &error);
    array_fail_nth(0);
    if (status == STATUS_OK) material_free(&material);
  }
  ck_assert_int_eq(status, STATUS_OK);
  mesh_free(&mesh);
}
END_TEST

int main(void) {
  if (!scratch_make()) return EXIT_FAILURE;
  const int code =
      suite_run("field", (SuiteTests){a_spot_covers_the_cap_that_it_should,
                                      a_file_gives_its_numbers_in_order_and_says_what_is_wrong_with_it,
                                      scatter_has_the_mean_that_is_asked_for,
                                      correlated_scatter_is_the_same_field_on_every_mesh,
                                      a_value_out_of_range_is_named_with_its_element,
                                      a_value_that_the_law_does_not_take_is_named_with_its_element,
                                      a_law_with_more_parameters_than_can_vary_is_refused,
                                      numbers_that_make_no_distribution_are_refused,
                                      a_field_that_is_the_same_everywhere_is_a_number,
                                      every_element_has_the_damage_of_its_own_strength,
                                      a_spot_around_P_keeps_the_half_turn_and_gives_the_same_force_with_it,
                                      moduli_must_be_those_of_a_stable_membrane_in_every_element,
                                      set_up_survives_every_failing_allocation, NULL});
  scratch_remove();
  return code;
}
