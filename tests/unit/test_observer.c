/* Laws that look on see what the law of a damaged membrane sees, and do nothing to it. */
#include "membrane/observer.h"

#include "shell.h"
#include "suite.h"

typedef struct {
  const char *law, *name[2];
  double value[2];
} Case;

/* One law of each kind: explicit, general with history, general with rates and time. */
static const Case CASES[] = {
    {"marigo", {"Y_D", "Y_C"}, {0.02, 0.5}},
    {"rankine", {"T_D", "T_C"}, {0.1, 2}},
    {"creep", {"T_R", "tau"}, {0.5, 1}},
};
enum { N_CASES = sizeof CASES / sizeof *CASES };

/* Valid until the next call. */
static SceneLaw law_of(const Case *c) {
  static SceneParameter parameters[2];
  for (int k = 0; k < 2; k++) parameters[k] = number(c->name[k], c->value[k]);
  return scene_law(c->law, parameters, 2);
}

static void make_criteria(Material criterion[N_CASES]) {
  const LawSearch search = test_search();
  const Scene scene = {0};
  Error error;
  for (int i = 0; i < N_CASES; i++) {
    const SceneLaw law = law_of(&CASES[i]);
    ck_assert_int_eq(material_criterion(&criterion[i], &scene, &law, &search, &NO_SCALES, NULL, NULL, &error),
                     STATUS_OK);
  }
}

static void must_step(Observers *observers, size_t i, double t, double dt) {
  Error error;
  ck_assert_int_eq(observers_step(observers, i, t, dt, &error), STATUS_OK);
}

/* A path of the membrane with damage law `c`: at each step a trial that comes to nothing, then the one that
 * is accepted.  The observers watch; that with the same law must have the same damage to the last bit, since
 * a law sees the undamaged membrane. */
static void watch_membrane_with(const Case *c, const Material *criterion) {
  Shell shell;
  Observers observers;
  Error error;
  shell_open_with(&shell, 1, scene_law("neo_hookean", NULL, 0), law_of(c), MASS_PCG);
  ck_assert_int_eq(observers_new(&observers, shell.membrane, criterion, N_CASES, &error), STATUS_OK);
  const size_t bytes = (size_t)membrane_points(shell.membrane) * sizeof(double);
  double *x = zeros(shell.n), *R = zeros(shell.n), most = 0;
  for (int step = 0; step < 6; step++) {
    const double scale[] = {1.3, 1 + 0.06 * step};
    for (int trial = 0; trial < 2; trial++) {
      shell_crumple(&shell, scale[trial], 0.01, (uint64_t)step, x);
      must_force(&shell, x, R);
      observers_read(&observers);
      for (size_t i = 0; i < N_CASES; i++) must_step(&observers, i, 0, 0.1); /* times of must_force */
    }
    const MembraneHistory *history = membrane_trial(shell.membrane);
    const ObserverHistory *seen = &observers.history[c - CASES];
    ck_assert_mem_eq(seen->d, history->d, bytes);
    most = fmax(most, seen->d[membrane_largest(shell.membrane, seen->d)]);
    observers_commit(&observers);
    membrane_commit(shell.membrane);
    ck_assert_mem_eq(observers.history0[c - CASES].Ymax, membrane_accepted(shell.membrane)->Ymax, bytes);
  }
  ck_assert_double_gt(most, 0.1); /* there was something to see */
  free(x);
  free(R);
  observers_free(&observers);
  shell_close(&shell);
}

START_TEST(an_observer_finds_the_damage_of_a_membrane_with_its_law) {
  Material criterion[N_CASES];
  make_criteria(criterion);
  for (int i = 0; i < N_CASES; i++) watch_membrane_with(&CASES[i], criterion);
  for (int i = 0; i < N_CASES; i++) material_free(&criterion[i]);
}
END_TEST

START_TEST(only_a_commit_changes_what_is_accepted) {
  Material criterion[N_CASES];
  Shell shell;
  Observers observers;
  Error error;
  make_criteria(criterion);
  shell_open(&shell, 1);
  ck_assert_int_eq(observers_new(&observers, shell.membrane, criterion, N_CASES, &error), STATUS_OK);
  double *x = zeros(shell.n), *R = zeros(shell.n), *before = zeros((int)observers.size);
  memcpy(before, observers.accepted, observers.size * sizeof *before);
  shell_inflate(&shell, 1.5, x);
  must_force(&shell, x, R);
  observers_read(&observers);
  for (size_t i = 0; i < N_CASES; i++) must_step(&observers, i, 0, 0.1);
  ck_assert_mem_eq(observers.accepted, before, observers.size * sizeof *before);
  observers_commit(&observers);
  ck_assert_mem_eq(observers.accepted, observers.trial, observers.size * sizeof *before);
  for (int i = 0; i < N_CASES; i++) ck_assert_double_gt(observers.history0[i].d[0], 0);
  free(x);
  free(R);
  free(before);
  observers_free(&observers);
  for (int i = 0; i < N_CASES; i++) material_free(&criterion[i]);
  shell_close(&shell);
}
END_TEST

int main(void) {
  return suite_run("observer", (SuiteTests){an_observer_finds_the_damage_of_a_membrane_with_its_law,
                                            only_a_commit_changes_what_is_accepted, NULL});
}
