/* A program that no mpirun has started is one rank; jobs of several are the business of scene.threshold. */
#include "study/ranks.h"
#include "suite.h"

START_TEST(a_program_alone_is_one_rank_without_messages) {
  Error error;
  Message message = {0};
  bool received = true;
  unsetenv("OMPI_COMM_WORLD_SIZE");
  ck_assert_int_eq(setenv("PMI_SIZE", "1", 1), 0);
  ck_assert_int_eq(ranks_open(&error), STATUS_OK);
  ck_assert_int_eq(ranks_own(), 0);
  ck_assert_int_eq(ranks_count(), 1);
  ck_assert_int_eq(ranks_receive(&message, &received, &error), STATUS_OK);
  ck_assert(!received);
  ranks_close();
  ck_assert_int_eq(ranks_count(), 1);
}
END_TEST

int main(void) {
  return suite_run("ranks", (SuiteTests){a_program_alone_is_one_rank_without_messages, NULL});
}
