/* A whole run when memory gives out: at every allocation of set-up and steps in turn, the run ends with that
 * reason, and what it leaves can be resumed. */
#include "run/run.h"

#include "base/array.h"
#include "base/file.h"
#include "scratch.h"
#include "suite.h"
#include <string.h>
#include <unistd.h>

static const char SCENE[] = "schema: 1\n"
                            "capsule: {mesh: {subdivisions: 0}}\n"
                            "membrane:\n"
                            "  law: neo_hookean\n"
                            "  check_laws: false\n"
                            "  damage: {law: marigo, parameters: {Y_D: 0.2, Y_C: {around: P, radius: 1, "
                            "inside: 1, outside: 2}}}\n"
                            "flow: {kind: simple_shear, capillary_number: 0.7}\n"
                            "observe: {criteria: [{law: rankine, parameters: {T_D: 0.01, T_C: 0.1}}]}\n"
                            "time: {end: 0.02, tolerance: 0.1}\n"
                            "output: {history_every: 0.01, snapshot_every: 0.01, report: false}\n";

static Status run(const char *folder, bool resume, Error *error) {
  Text path = {0};
  Outcome outcome;
  const RunOptions options = {.scene_path = scratch_path("scene.yaml"),
                              .folder = folder,
                              .resume = resume,
                              .threads = 1,
                              .quiet = true};
  const Status status = run_scene(&options, &outcome, &path, error);
  text_free(&path);
  return status;
}

START_TEST(a_run_out_of_memory_at_any_point_says_so_and_leaves_a_whole_folder) {
  Error error;
  char folder[512]; /* the path that scratch_path gives lives for eight calls */
  snprintf(folder, sizeof folder, "%s", scratch_path("out"));
  Text whole = {0}, history = {0};
  ck_assert_int_eq(file_write(scratch_path("scene.yaml"), SCENE, strlen(SCENE), &error), STATUS_OK);
  ck_assert_msg(run(folder, false, &error) == STATUS_OK, "%s", error.text);
  ck_assert_int_eq(file_read(scratch_path("out/history.csv"), 1 << 20, &whole, &error), STATUS_OK);

  long n = 1, failures = 0;
  for (Status status = STATUS_MEMORY;; n++) {
    array_fail_nth(n);
    status = run(folder, false, &error);
    if (array_fail_nth(0) > 0) break; /* the run needs no n allocations */
    failures++;
    ck_assert_msg(status == STATUS_MEMORY, "allocation %ld: status %d, %s", n, (int)status, error.text);
    ck_assert_msg(strstr(error.text, "memory"), "allocation %ld: %s", n, error.text);
  }
  ck_assert_int_gt(failures, 100);

  ck_assert_msg(run(folder, true, &error) == STATUS_OK, "%s", error.text);
  ck_assert_int_eq(file_read(scratch_path("out/history.csv"), 1 << 20, &history, &error), STATUS_OK);
  ck_assert_str_eq(history.data, whole.data);
  text_free(&whole);
  text_free(&history);
  file_remove_folder(folder);
}
END_TEST

int main(void) {
  /* Hundreds of runs, each of which waits for the disk many times: in memory where there is such a folder. */
  static char in_memory[] = "/dev/shm/capsella-test-XXXXXX";
  if (access("/dev/shm", W_OK) == 0) scratch_folder = in_memory;
  if (!scratch_make() || setenv("MLAW_PLUGIN_PATH", BUILD_DIR "/plugins", 1) != 0) return 1;
  const int failed = suite_run(
      "run", (SuiteTests){a_run_out_of_memory_at_any_point_says_so_and_leaves_a_whole_folder, NULL});
  scratch_remove();
  return failed;
}
