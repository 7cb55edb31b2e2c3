/* Processes side by side: how they end, what they are given, and that none is left behind. */
#include "study/launcher.h"
#include "study_file.h"
#include "suite.h"
#include <signal.h>
#include <time.h>

static Launcher *launcher;

static void open_launcher(int slots, const char *program) {
  Error error;
  ck_assert_int_eq(launcher_new(&launcher, slots, program, &error), STATUS_OK);
}

/* Starts a line of shell. */
static void start(int slot, const char *lock, char *command) {
  Error error;
  char shell[] = "sh", option[] = "-c";
  char *const arguments[] = {shell, option, command, NULL};
  const Job job = {arguments, scratch_path(lock), scratch_path("messages"), "/a:/b"};
  ck_assert_int_eq(launcher_start(launcher, slot, &job, &error), STATUS_OK);
}

static JobEnd await(void) {
  Error error;
  JobEnd end;
  do ck_assert_int_eq(launcher_poll(launcher, &end, &error), STATUS_OK);
  while (end.slot < 0);
  return end;
}

static void expect_content(const char *name, const char *expected) {
  Error error;
  Text content = {0};
  ck_assert_int_eq(file_read(scratch_path(name), 1 << 16, &content, &error), STATUS_OK);
  ck_assert_str_eq(content.data, expected);
  text_free(&content);
}

START_TEST(the_end_of_a_process_is_told_with_its_slot_and_code) {
  char three[] = "exit 3", nothing[] = ":";
  open_launcher(2, "/bin/sh");
  ck_assert_int_eq(launcher_slots(launcher), 2);
  start(1, "a", three);
  JobEnd end = await();
  ck_assert(end.slot == 1 && end.code == 3 && end.signal == 0);
  start(0, "a", nothing);
  end = await();
  ck_assert(end.slot == 0 && end.code == 0 && end.signal == 0);
  launcher_free(launcher);
}
END_TEST

START_TEST(a_process_that_is_killed_is_told_with_the_signal) {
  char killed[] = "kill -KILL $$";
  open_launcher(1, "/bin/sh");
  start(0, "a", killed);
  const JobEnd end = await();
  ck_assert(end.slot == 0 && end.code == -1 && end.signal == SIGKILL);
  launcher_free(launcher);
}
END_TEST

START_TEST(a_program_that_cannot_be_started_ends_with_the_code_of_the_shell) {
  char nothing[] = ":";
  open_launcher(1, "/no/such/program");
  start(0, "a", nothing);
  ck_assert_int_eq(await().code, 127);
  launcher_free(launcher);
}
END_TEST

START_TEST(errors_go_to_a_file_and_input_and_output_nowhere) {
  char talk[] = "echo lost; cat; echo \"plugins: $MLAW_PLUGIN_PATH\" >&2";
  open_launcher(1, "/bin/sh");
  start(0, "a", talk);
  ck_assert_int_eq(await().code, 0);
  expect_content("messages", "plugins: /a:/b\n");
  launcher_free(launcher);
}
END_TEST

/* Until a process has made a file. */
static void await_file(const char *name) {
  static const struct timespec moment = {.tv_nsec = 1000000};
  while (!file_exists(scratch_path(name))) nanosleep(&moment, NULL);
}

START_TEST(a_process_waits_for_the_lock_of_another) {
  char first[2048], second[1024];
  snprintf(first, sizeof first, "touch %s; sleep 0.2; printf 1 >>%s", scratch_path("begun"),
           scratch_path("order"));
  snprintf(second, sizeof second, "printf 2 >>%s", scratch_path("order"));
  open_launcher(2, "/bin/sh");
  start(0, "same", first);
  await_file("begun"); /* which holds the lock by then */
  start(1, "same", second);
  await();
  await();
  expect_content("order", "12");
  launcher_await_lock(scratch_path("same"));
  launcher_free(launcher);
}
END_TEST

START_TEST(processes_can_be_asked_to_stop_and_none_outlives_the_launcher) {
  char slow[] = "exec sleep 100";
  signal(SIGTERM, SIG_DFL); /* Check's own handler would be met by a process that has not become sleep yet */
  open_launcher(2, "/bin/sh");
  start(0, "a", slow);
  start(1, "b", slow);
  launcher_stop(launcher);
  const JobEnd end = await();
  ck_assert(end.code == -1 && end.signal == SIGTERM);
  start(end.slot, "c", slow);
  launcher_free(launcher);
  launcher_await_lock(scratch_path("a"));
  launcher_await_lock(scratch_path("b"));
  launcher_await_lock(scratch_path("c"));
}
END_TEST

int main(void) {
  if (!scratch_make()) return 1;
  const int failed = suite_run(
      "launcher",
      (SuiteTests){the_end_of_a_process_is_told_with_its_slot_and_code,
                   a_process_that_is_killed_is_told_with_the_signal,
                   a_program_that_cannot_be_started_ends_with_the_code_of_the_shell,
                   errors_go_to_a_file_and_input_and_output_nowhere, a_process_waits_for_the_lock_of_another,
                   processes_can_be_asked_to_stop_and_none_outlives_the_launcher, NULL});
  scratch_remove();
  return failed;
}
