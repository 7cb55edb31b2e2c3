/* A journal keeps what was written before a crash, and nothing half written. */
#include "scratch.h"
#include "study/journal.h"
#include "suite.h"
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

static Journal reopened(void) {
  Journal journal;
  Error error;
  const Status status = journal_open(&journal, scratch_folder, &error);
  ck_assert_msg(status == STATUS_OK, "%s", status == STATUS_OK ? "" : error.text);
  return journal;
}

static void add(Journal *journal, JournalState state, const char *label, uint64_t identity,
                const char *reason) {
  Error error;
  ck_assert_int_eq(journal_add(journal, state, label, identity, reason, &error), STATUS_OK);
}

START_TEST(the_last_line_about_a_case_counts) {
  scratch_empty();
  Journal journal = reopened();
  add(&journal, JOURNAL_STARTED, "a", 1, NULL);
  add(&journal, JOURNAL_STARTED, "b", 2, NULL);
  add(&journal, JOURNAL_DONE, "a", 1, NULL);
  add(&journal, JOURNAL_FAILED, "b", UINT64_C(0xfedcba9876543210), "no step\nis small enough");
  journal_close(&journal);
  journal = reopened();
  ck_assert_int_eq(journal_find(&journal, "a")->state, JOURNAL_DONE);
  const JournalEntry *b = journal_find(&journal, "b");
  ck_assert_int_eq(b->state, JOURNAL_FAILED);
  ck_assert(b->identity == UINT64_C(0xfedcba9876543210));
  ck_assert_str_eq(b->reason, "no step is small enough");
  ck_assert_ptr_null(journal_find(&journal, "c"));
  journal_close(&journal);
}
END_TEST

START_TEST(a_line_cut_off_by_a_crash_is_dropped_and_the_next_one_stands_alone) {
  scratch_empty();
  Journal journal = reopened();
  add(&journal, JOURNAL_STARTED, "a", 1, NULL);
  journal_close(&journal);
  FILE *file = fopen(scratch_path("journal.txt"), "a");
  fputs("done a 00000000000", file);
  fclose(file);
  journal = reopened();
  ck_assert_int_eq(journal_find(&journal, "a")->state, JOURNAL_STARTED);
  add(&journal, JOURNAL_DONE, "b", 2, NULL);
  journal_close(&journal);
  journal = reopened();
  ck_assert_int_eq(journal_find(&journal, "a")->state, JOURNAL_STARTED);
  ck_assert_int_eq(journal_find(&journal, "b")->state, JOURNAL_DONE);
  journal_close(&journal);
}
END_TEST

START_TEST(a_second_process_cannot_open_it) {
  scratch_empty();
  Journal journal = reopened();
  const pid_t process = fork();
  if (process == 0) {
    Journal other;
    Error error;
    const Status status = journal_open(&other, scratch_folder, &error);
    _exit(status == STATUS_IO && strstr(error.text, "another study is at work") ? 0 : 1);
  }
  int how;
  ck_assert(waitpid(process, &how, 0) == process && WIFEXITED(how));
  ck_assert_int_eq(WEXITSTATUS(how), 0);
  journal_close(&journal);
}
END_TEST

START_TEST(an_emptied_journal_knows_nothing) {
  scratch_empty();
  Error error;
  Journal journal = reopened();
  add(&journal, JOURNAL_DONE, "a", 1, NULL);
  ck_assert_int_eq(journal_empty(&journal, &error), STATUS_OK);
  ck_assert_ptr_null(journal_find(&journal, "a"));
  add(&journal, JOURNAL_DONE, "b", 1, NULL);
  journal_close(&journal);
  journal = reopened();
  ck_assert_ptr_null(journal_find(&journal, "a"));
  ck_assert_ptr_nonnull(journal_find(&journal, "b"));
  journal_close(&journal);
}
END_TEST

START_TEST(a_journal_that_cannot_be_opened_written_or_emptied_says_so) {
  Journal journal;
  Error error;
  ck_assert_int_eq(journal_open(&journal, scratch_path("none"), &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "none/journal.txt: cannot be opened: "));
  journal_close(&journal);
  scratch_empty();
  journal = reopened();
  close(journal.handle);
  journal.handle = open(scratch_path("journal.txt"), O_RDONLY);
  ck_assert_int_eq(journal_add(&journal, JOURNAL_STARTED, "a", 1, NULL, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "the journal cannot be written: "));
  ck_assert_int_eq(journal_empty(&journal, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "the journal cannot be emptied: "));
  journal_close(&journal);
}
END_TEST

int main(void) {
  if (!scratch_make()) return 1;
  const int code =
      suite_run("journal", (SuiteTests){the_last_line_about_a_case_counts,
                                        a_line_cut_off_by_a_crash_is_dropped_and_the_next_one_stands_alone,
                                        a_second_process_cannot_open_it, an_emptied_journal_knows_nothing,
                                        a_journal_that_cannot_be_opened_written_or_emptied_says_so, NULL});
  scratch_remove();
  return code;
}
