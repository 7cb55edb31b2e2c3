#include "study/benchmark.h"

#include "base/array.h"
#include "base/timer.h"
#include "fluid/oseen_kernel.h"
#include "mesh/quadrature.h"
#include "observe/shape.h"
#include "run/simulation.h"
#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { REPEATS = 9, MAX_SETS = 32 };

static const char REFERENCE_CASE[] = "schema: 1\n"
                                     "membrane:\n"
                                     "  law: neo_hookean\n"
                                     "  parameters: {G_s: 1.0}\n"
                                     "  damage: {law: marigo, parameters: {Y_D: 0.2, Y_C: 2.0}}\n"
                                     "flow: {kind: simple_shear, capillary_number: 0.7}\n"
                                     "time: {end: 10, integrator: rkc2}\n"
                                     "output: {snapshot_every: 0, history_every: 0}\n";

static int compare_doubles(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static double median(double *values, int n) {
  qsort(values, (size_t)n, sizeof *values, compare_doubles);
  return values[n / 2];
}

static Status read_case(Scene *scene, const char *const *sets, Error *error) {
  size_t n = 0;
  while (sets[n]) n++;
  return scene_read_text(scene, "reference case", REFERENCE_CASE, strlen(REFERENCE_CASE), sets, n, error);
}

/* Keys with numbers in them, as text that lives as long as the scene is read. */
static const char *set_number(char *buffer, size_t size, const char *key, int value) {
  snprintf(buffer, size, "%s=%d", key, value);
  return buffer;
}
static const char *set_word(char *buffer, size_t size, const char *key, const char *value) {
  snprintf(buffer, size, "%s=%s", key, value);
  return buffer;
}

static void stretch(const Mesh *mesh, const double axes[3], double *x) {
  for (int p = 0; p < mesh->n_nodes; p++)
    for (int c = 0; c < 3; c++) x[3 * p + c] = axes[c] * mesh->X[3 * p + c];
}

/* ---- one evaluation ---- */

static Status time_evaluation(Simulation *s, const double *x, double *v, EvaluationCost *cost, Error *error) {
  Status status = STATUS_OK;
  double whole[REPEATS], membrane[REPEATS];
  for (int k = -1; k < REPEATS; k++) { /* one more to warm up */
    const KernelCount before = single_layer_count(s->layer);
    double start = timer_wall_seconds();
    TRY(system_velocity(&s->system, x, 0, 0, v, error));
    if (k >= 0) whole[k] = timer_wall_seconds() - start;
    const KernelCount after = single_layer_count(s->layer);
    cost->far = after.far - before.far;
    cost->near = after.near - before.near;
    cost->singular = after.singular - before.singular;
    start = timer_wall_seconds();
    TRY(membrane_force(s->membrane, x, 0, 0, s->system.R, error));
    TRY(membrane_load(s->membrane, s->system.R, s->system.q, error));
    if (k >= 0) membrane[k] = timer_wall_seconds() - start;
  }
  cost->milliseconds = 1e3 * median(whole, REPEATS);
  cost->membrane_milliseconds = 1e3 * median(membrane, REPEATS);
cleanup:
  return status;
}

Status benchmark_evaluation(EvaluationCost *cost, Error *error) {
  Status status = STATUS_OK;
  Scene scene = {0};
  Simulation s = {0};
  double *x = NULL, *v = NULL;
  char mesh[64], method[64];
  const char *const sets[] = {set_number(mesh, sizeof mesh, "capsule.mesh.subdivisions", cost->subdivisions),
                              set_word(method, sizeof method, "fluid.method", cost->method),
                              cost->symmetric ? "symmetry=auto" : "symmetry=off", NULL};
  omp_set_num_threads(cost->threads);
  TRY(read_case(&scene, sets, error));
  TRY(simulation_new(&s, &scene, NULL, error));
  TRY(ARRAY_NEW(&x, 3 * (size_t)s.mesh.n_nodes, error));
  TRY(ARRAY_NEW(&v, 3 * (size_t)s.mesh.n_nodes, error));
  stretch(&s.mesh, (double[]){2, 1, 0.5}, x);
  cost->elements = s.mesh.n_elements;
  TRY(time_evaluation(&s, x, v, cost, error));
cleanup:
  array_free(x);
  array_free(v);
  simulation_free(&s);
  scene_free(&scene);
  return status;
}

/* ---- accuracy of the single layer ---- */

/* Integrals of the ellipsoid over s from 0 to infinity, by Gauss points in s = u/(1 - u) pieces. */
static void ellipsoid_integrals(const double axes[3], double *chi, double alpha[3]) {
  enum { POINTS = 32, PIECES = 64 };
  double node[POINTS], weight[POINTS];
  gauss_rule(POINTS, node, weight);
  *chi = alpha[0] = alpha[1] = alpha[2] = 0;
  for (int piece = 0; piece < PIECES; piece++)
    for (int i = 0; i < POINTS; i++) {
      /* s = w^2/(1-w)^2 makes the integrand smooth at both ends */
      const double w = (piece + node[i]) / PIECES, r = w / (1 - w), s = r * r;
      const double ds = 2 * r / ((1 - w) * (1 - w)) * weight[i] / PIECES;
      double delta = 1;
      for (int c = 0; c < 3; c++) delta *= axes[c] * axes[c] + s;
      delta = sqrt(delta);
      *chi += ds / delta;
      for (int c = 0; c < 3; c++) alpha[c] += ds / ((axes[c] * axes[c] + s) * delta);
    }
}

/* Load of a rigid ellipsoid that moves with velocity U: q_i = F_i / (4 pi abc) (sum x^2/a^4)^(-1/2) and
 * U_i = F_i (chi + alpha_i a_i^2) / (16 pi), for a unit velocity along (1, 1, 1). */
static void translation_load(const Mesh *mesh, const double axes[3], const double *x, double *q) {
  double chi, alpha[3];
  ellipsoid_integrals(axes, &chi, alpha);
  const double pi = 3.14159265358979323846;
  for (int p = 0; p < mesh->n_nodes; p++) {
    double sum = 0;
    for (int c = 0; c < 3; c++) sum += x[3 * p + c] * x[3 * p + c] / pow(axes[c], 4);
    for (int c = 0; c < 3; c++) {
      const double force = 16 * pi / (chi + alpha[c] * axes[c] * axes[c]) / sqrt(3.0);
      q[3 * p + c] = force / (4 * pi * axes[0] * axes[1] * axes[2]) / sqrt(sum);
    }
  }
}

static Status evaluate_layer(const Mesh *mesh, FluidMethod method, const double *x, const double *q,
                             double *u, Error *error) {
  SingleLayer *layer = NULL;
  Status status = STATUS_OK;
  TRY(single_layer_new(&layer, mesh, method, error));
  TRY(single_layer_evaluate(layer, x, q, u, error));
cleanup:
  single_layer_free(layer);
  return status;
}

static FluidMethod method_of(const char *name) {
  if (strcmp(name, "direct") == 0) return FLUID_DIRECT;
  return strcmp(name, "fast") == 0 ? FLUID_FAST : FLUID_REFERENCE;
}

Status benchmark_layer(LayerError *result, Error *error) {
  Status status = STATUS_OK;
  Mesh mesh = {0};
  double *x = NULL, *q = NULL, *u = NULL, *best = NULL;
  TRY(mesh_sphere(&mesh, result->subdivisions, NULL, error));
  const size_t n = 3 * (size_t)mesh.n_nodes;
  TRY(ARRAY_NEW(&x, n, error));
  TRY(ARRAY_NEW(&q, n, error));
  TRY(ARRAY_NEW(&u, n, error));
  TRY(ARRAY_NEW(&best, n, error));
  stretch(&mesh, result->axes, x);
  translation_load(&mesh, result->axes, x, q);
  TRY(evaluate_layer(&mesh, method_of(result->method), x, q, u, error));
  TRY(evaluate_layer(&mesh, FLUID_REFERENCE, x, q, best, error));
  result->error = result->quadrature = 0;
  for (size_t i = 0; i < n; i += 3) {
    double exact = 0, difference = 0;
    for (size_t c = i; c < i + 3; c++) {
      exact += pow(u[c] - 1 / sqrt(3.0), 2);
      difference += pow(u[c] - best[c], 2);
    }
    result->error = fmax(result->error, sqrt(exact));
    result->quadrature = fmax(result->quadrature, sqrt(difference));
  }
cleanup:
  array_free(x);
  array_free(q);
  array_free(u);
  array_free(best);
  mesh_free(&mesh);
  return status;
}

/* ---- whole runs ---- */

static double largest(const double *values, int n) {
  double most = values[0];
  for (int k = 1; k < n; k++) most = fmax(most, values[k]);
  return most;
}

static Status advance_to_end(Simulation *s, RunCost *run, Error *error) {
  Status status = STATUS_OK;
  const int points = membrane_points(s->membrane);
  Motion *motion = s->motion;
  TRY(simulation_start(s, error));
  while (motion->t < s->scene->time.end) {
    double t1;
    TRY(motion->propose(motion, s->scene->time.end, &t1, NULL, error));
    run->Y_max = fmax(run->Y_max, largest(membrane_points_view(s->membrane).phi, points));
    motion->accept(motion);
    membrane_commit(s->membrane);
  }
cleanup:
  return status;
}

static Status measure_end(const Simulation *s, RunCost *run, Error *error) {
  Shape shape;
  const Status status = shape_measure(&s->mesh, s->stepper.x, s->flow.vorticity_axis, &shape, error);
  if (status != STATUS_OK) return status;
  run->t = s->motion->t;
  run->D12 = shape.D12;
  run->beta = shape.beta;
  run->L[0] = shape.L1;
  run->L[1] = shape.L2;
  run->L[2] = shape.L3;
  run->area_strain = shape.area / s->area0 - 1;
  const double *d = membrane_accepted(s->membrane)->d;
  run->d_max = d ? largest(d, membrane_points(s->membrane)) : 0;
  const KernelCount count = single_layer_count(s->layer);
  run->pairs = count.far + count.near + count.singular;
  run->evaluations = s->system.evaluations;
  return STATUS_OK;
}

Status benchmark_run(RunCost *run, Error *error) {
  Status status = STATUS_OK;
  Scene scene = {0};
  Simulation s = {0};
  run->Y_max = 0;
  omp_set_num_threads(run->threads);
  const double wall = timer_wall_seconds(), cpu = timer_cpu_seconds();
  TRY(read_case(&scene, run->sets, error));
  TRY(simulation_new(&s, &scene, NULL, error));
  TRY(advance_to_end(&s, run, error));
  TRY(measure_end(&s, run, error));
  run->seconds = timer_wall_seconds() - wall;
  run->cpu_seconds = timer_cpu_seconds() - cpu;
cleanup:
  simulation_free(&s);
  scene_free(&scene);
  return status;
}

/* ---- the machine ---- */

double benchmark_kernel_rate(void) {
  enum { BLOCKS = 960, SOURCES = BLOCKS * OSEEN_LANES, TARGETS = 400 };
  static OseenBlock block[BLOCKS];
  const OseenRun run = {block, BLOCKS};
  for (int i = 0; i < SOURCES; i++) {
    for (int c = 0; c < 3; c++) {
      block[i / OSEEN_LANES].y[c][i % OSEEN_LANES] = sin(i + 1.0 + c);
      block[i / OSEEN_LANES].f[c][i % OSEEN_LANES] = cos(2.0 * i + c);
    }
  }
  double seconds[REPEATS], u[3] = {0, 0, 0};
  for (int k = 0; k < REPEATS; k++) {
    const double start = timer_wall_seconds();
    for (int i = 0; i < TARGETS; i++) {
      const double x[3] = {2.0 + i, 0.5, 0.25};
      oseen_sum(&run, 1, x, u);
    }
    seconds[k] = timer_wall_seconds() - start;
  }
  return (double)SOURCES * TARGETS / median(seconds, REPEATS);
}

static Status append_processor(Text *text, Error *error) {
  char line[256];
  FILE *file = fopen("/proc/cpuinfo", "r");
  Status status = STATUS_OK;
  while (file && fgets(line, sizeof line, file))
    if (strncmp(line, "model name", 10) == 0) {
      const char *name = strchr(line, ':');
      status = text_append(text, error, "- processor:%.*s\n", (int)strcspn(name + 1, "\n"), name + 1);
      break;
    }
  if (file) fclose(file);
  return status;
}

Status benchmark_machine(Text *text, Error *error) {
  Status status = STATUS_OK;
  char date[32];
  const time_t now = time(NULL);
  struct tm day;
  strftime(date, sizeof date, "%Y-%m-%d", gmtime_r(&now, &day));
  TRY(text_append(text, error, "- date: %s\n- capsella " CAPSELLA_VERSION ", compiler: " __VERSION__ "\n",
                  date));
  TRY(append_processor(text, error));
  TRY(text_append(text, error, "- logical processors: %d\n", omp_get_num_procs()));
  TRY(text_append(text, error, "- bare kernel: %.2f 10^9 pairs/s on one thread\n",
                  1e-9 * benchmark_kernel_rate()));
cleanup:
  return status;
}
