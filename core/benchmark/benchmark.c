#include "benchmark/benchmark.h"

#include "base/array.h"
#include "base/timer.h"
#include "fluid/oseen_kernel.h"
#include "observe/shape.h"
#include "run/record.h"
#include "run/simulation.h"
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

enum { REPEATS = 9, MAX_SETS = 32 };

static const char REFERENCE_CASE[] = "schema: 1\n"
                                     "membrane:\n"
                                     "  law: neo_hookean\n"
                                     "  parameters: {G_s: 1.0}\n"
                                     "  damage: {law: marigo, parameters: {Y_D: 0.2, Y_C: 2.0}}\n"
                                     "flow: {kind: simple_shear, capillary_number: 0.7}\n"
                                     "time: {end: 10, integrator: rkc3}\n"
                                     "output: {snapshot_every: 0, history_every: 0}\n";

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
    TRY(membrane_load(s->membrane, LOAD_FULL, s->system.R, s->system.q, error));
    if (k >= 0) membrane[k] = timer_wall_seconds() - start;
  }
  cost->milliseconds = 1e3 * timer_median(whole, REPEATS);
  cost->membrane_milliseconds = 1e3 * timer_median(membrane, REPEATS);
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

/* ---- the same law compiled in ---- */

static Status time_force(Simulation *s, const double *x, double *seconds, Error *error) {
  const double start = timer_wall_seconds();
  const Status status = membrane_force(s->membrane, x, 0, 0, s->system.R, error);
  *seconds = timer_wall_seconds() - start;
  return status;
}

Status benchmark_law(const mlaw_energy *compiled_in, LawCost *cost, Error *error) {
  enum { CALLS = 801 };
  Status status = STATUS_OK;
  Scene scene = {0};
  Simulation s = {0};
  double *x = NULL, loaded[CALLS], linked[CALLS];
  omp_set_num_threads(1);
  TRY(read_case(&scene, (const char *const[]){"symmetry=off", NULL}, error));
  TRY(simulation_new(&s, &scene, NULL, error));
  TRY(ARRAY_NEW(&x, 3 * (size_t)s.mesh.n_nodes, error));
  stretch(&s.mesh, (double[]){2, 1, 0.5}, x);
  const mlaw_energy *plugin = s.material.elastic.energy;
  for (int k = 0; k < CALLS; k++) { /* by turns, so that both meet the same noise */
    s.material.elastic.energy = plugin;
    TRY(time_force(&s, x, &loaded[k], error));
    s.material.elastic.energy = compiled_in;
    TRY(time_force(&s, x, &linked[k], error));
  }
  s.material.elastic.energy = plugin;
  cost->plugin_microseconds = 1e6 * timer_median(loaded, CALLS);
  cost->compiled_in_microseconds = 1e6 * timer_median(linked, CALLS);
cleanup:
  array_free(x);
  simulation_free(&s);
  scene_free(&scene);
  return status;
}

/* ---- whole runs ---- */

static double largest(const double *values, int n) {
  double most = values[0];
  for (int k = 1; k < n; k++) most = fmax(most, values[k]);
  return most;
}

static Status advance(Simulation *s, double t_end, double *Y_max, Error *error) {
  Status status = STATUS_OK;
  const int points = membrane_points(s->membrane);
  Motion *motion = s->motion;
  while (motion->t < t_end) {
    double t1;
    TRY(motion->propose(motion, t_end, &t1, NULL, error));
    *Y_max = fmax(*Y_max, largest(membrane_points_view(s->membrane).phi, points));
    motion->accept(motion);
    membrane_commit(s->membrane);
  }
cleanup:
  return status;
}

static Status measure_state(const Simulation *s, RunState *state, Error *error) {
  Shape shape;
  const Status status =
      shape_measure(&s->mesh, &s->symmetry, s->stepper.x, s->flow.vorticity_axis, &shape, error);
  if (status != STATUS_OK) return status;
  const double *d = membrane_accepted(s->membrane)->d;
  *state = (RunState){.t = s->motion->t,
                      .D12 = shape.D12,
                      .beta = shape.beta,
                      .L = {shape.L1, shape.L2, shape.L3},
                      .area_strain = shape.area / s->area0 - 1,
                      .d_max = d ? largest(d, membrane_points(s->membrane)) : 0};
  return STATUS_OK;
}

static Status run_once(RunCost *run, Error *error) {
  Status status = STATUS_OK;
  Scene scene = {0};
  Simulation s = {0};
  double Y_max = 0;
  TRY(read_case(&scene, run->sets, error));
  TRY(simulation_new(&s, &scene, NULL, error));
  TRY(simulation_start(&s, error));
  for (size_t k = 0; k < run->n_times; k++) {
    TRY(advance(&s, run->times[k], &Y_max, error));
    TRY(measure_state(&s, &run->state[k], error));
    run->state[k].Y_max = Y_max;
  }
  const KernelCount count = single_layer_count(s.layer);
  run->pairs = count.far + count.near + count.singular;
  if (s.coarse) {
    const KernelCount coarse = coarse_layer_count(s.coarse);
    run->pairs += coarse.far + coarse.near + coarse.singular;
  }
  run->evaluations = s.system.evaluations;
cleanup:
  simulation_free(&s);
  scene_free(&scene);
  return status;
}

Status benchmark_run(RunCost *run, Error *error) {
  static const double WORTH_REPEATING = 1; /* seconds in all */
  Status status = STATUS_OK;
  double wall[BENCHMARK_RUNS], cpu[BENCHMARK_RUNS], sum = 0;
  int n = 0;
  omp_set_num_threads(run->threads);
  do {
    const double wall0 = timer_wall_seconds(), cpu0 = timer_cpu_seconds();
    TRY(run_once(run, error));
    wall[n] = timer_wall_seconds() - wall0;
    cpu[n] = timer_cpu_seconds() - cpu0;
    sum += wall[n++];
  } while (n < BENCHMARK_RUNS && sum < WORTH_REPEATING);
  run->seconds = timer_median(wall, n);
  run->cpu_seconds = timer_median(cpu, n);
cleanup:
  return status;
}

static Status advance_to_rupture(Simulation *s, Record *record, Error *error) {
  static const double LATEST = 20;
  Status status;
  Motion *motion = s->motion;
  do {
    double t1;
    TRY(motion->propose(motion, LATEST, &t1, NULL, error));
    TRY(record_step(record, t1, error));
    TRY(record_events(record, error));
    TRY(record_probe(record, t1, error));
    TRY(record_advance(record, error));
    motion->accept(motion);
    membrane_commit(s->membrane);
  } while (isnan(record->data.t_l) && motion->t < LATEST);
  if (isnan(record->data.t_l))
    return error_set(error, STATUS_FAILED, "expected rupture up to t = %g, found none", LATEST);
cleanup:
  return status;
}

Status benchmark_rupture(RuptureCost *run, Error *error) {
  Status status;
  Scene scene = {0};
  Simulation s = {0};
  Record record = {0};
  omp_set_num_threads(run->threads);
  const double wall = timer_wall_seconds(), cpu = timer_cpu_seconds();
  TRY(read_case(&scene, run->sets, error));
  TRY(simulation_new(&s, &scene, NULL, error));
  TRY(record_new(&record, &s, error));
  TRY(simulation_start(&s, error));
  TRY(record_begin(&record, false, error));
  TRY(advance_to_rupture(&s, &record, error));
  run->t_c = record.data.t_c;
  run->t_l = record.data.t_l;
  run->evaluations = s.system.evaluations;
  run->seconds = timer_wall_seconds() - wall;
  run->cpu_seconds = timer_cpu_seconds() - cpu;
cleanup:
  record_free(&record);
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
  return (double)SOURCES * TARGETS / timer_median(seconds, REPEATS);
}

static Status append_processor(Text *text, Error *error) {
  char line[256];
  FILE *file = fopen("/proc/cpuinfo", "r");
  Status status = STATUS_OK;
  while (file && fgets(line, sizeof line, file))
    if (strncmp(line, "model name", 10) == 0) {
      const char *name = strchr(line, ':');
      if (name)
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
cleanup:
  return status;
}
