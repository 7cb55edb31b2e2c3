/* history.csv: the columns, exact numbers, and the cut back to a snapshot. */
#include "observe/history.h"

#include "base/file.h"
#include "scratch.h"
#include "suite.h"
#include <math.h>
#include <string.h>

static const char FLOW_HEADER[] =
    "t,D12,beta,L1,L2,L3,area_strain,volume_error,d_max,Y_max,T1_max,T2_min,"
    "compressed_area,wrinkle_amplitude,elastic_energy,dissipated_energy,energy_error,step,evaluations\n";

static const char *path(void) {
  return scratch_path("history.csv");
}

static HistoryRow row_at(double t) {
  return (HistoryRow){.t = t,
                      .D12 = t / 3,
                      .beta = t > 0 ? 0.1 * t : NAN,
                      .L1 = 2 + t,
                      .volume_error = -1e-17 * t,
                      .T2_min = -0.1,
                      .step = 0.05,
                      .evaluations = (long long)(1e15 * t)};
}

static void write_rows(History *history, HistoryKind kind, int rows) {
  Error error;
  ck_assert_int_eq(history_open(history, path(), kind, &error), STATUS_OK);
  for (int k = 0; k < rows; k++) {
    const HistoryRow row = row_at(0.1 * k);
    ck_assert_int_eq(history_append(history, &row, &error), STATUS_OK);
  }
}

static Text content(void) {
  Error error;
  Text text = {0};
  ck_assert_int_eq(file_read(path(), 1 << 20, &text, &error), STATUS_OK);
  return text;
}

static void append_bytes(const char *bytes) {
  FILE *file = fopen(path(), "ab");
  fputs(bytes, file);
  fclose(file);
}

START_TEST(the_columns_are_those_of_the_interface) {
  Error error;
  History history;
  write_rows(&history, HISTORY_FLOW, 0);
  ck_assert_int_eq(history_close(&history, &error), STATUS_OK);
  Text text = content();
  ck_assert_str_eq(text.data, FLOW_HEADER);
  text_free(&text);
  write_rows(&history, HISTORY_INFLATION, 0);
  ck_assert_int_eq(history_close(&history, &error), STATUS_OK);
  text = content();
  ck_assert_int_eq(strncmp(text.data, FLOW_HEADER, strlen(FLOW_HEADER) - 1), 0);
  ck_assert_str_eq(text.data + strlen(FLOW_HEADER) - 1, ",p,d,alpha\n");
  text_free(&text);
}
END_TEST

START_TEST(numbers_read_back_to_the_same_bits) {
  Error error;
  History history;
  HistoryRow row = {
      1 / 3., 2 / 3., NAN,  4 / 3.,  5 / 3., 7 / 3.,  1e-300, -1e-17,          0.1,     0.2,     0.3,
      -0.4,   0.6,    7e-4, 1e5 / 7, 1 / 7., -1 / 7., 0.05,   123456789012345, 11 / 3., 13 / 3., 17 / 3.};
  ck_assert_int_eq(history_open(&history, path(), HISTORY_INFLATION, &error), STATUS_OK);
  ck_assert_int_eq(history_append(&history, &row, &error), STATUS_OK);
  ck_assert_int_eq(history_close(&history, &error), STATUS_OK);
  Text text = content();
  const double expected[22] = {
      1 / 3., 2 / 3., NAN,  4 / 3.,  5 / 3., 7 / 3.,  1e-300, -1e-17,           0.1,     0.2,     0.3,
      -0.4,   0.6,    7e-4, 1e5 / 7, 1 / 7., -1 / 7., 0.05,   123456789012345., 11 / 3., 13 / 3., 17 / 3.};
  char *cell = strchr(text.data, '\n') + 1;
  for (int k = 0; k < 22; k++) {
    char *end;
    double value = strtod(cell, &end);
    if (isnan(expected[k]))
      ck_assert_int_eq(strncmp(cell, "nan,", 4), 0);
    else
      ck_assert_msg(memcmp(&value, &expected[k], sizeof value) == 0, "column %d", k);
    ck_assert_int_eq(*end, k < 21 ? ',' : '\n');
    cell = end + 1;
  }
  ck_assert_int_eq(*cell, '\0');
  text_free(&text);
}
END_TEST

START_TEST(a_row_is_in_the_file_when_the_call_returns) {
  Error error;
  History history;
  write_rows(&history, HISTORY_FLOW, 3);
  Text text = content(); /* before it is closed or synced */
  ck_assert_int_eq((long long)text.length, history.bytes);
  ck_assert_int_eq(text.data[text.length - 1], '\n');
  text_free(&text);
  ck_assert_int_eq(history_sync(&history, &error), STATUS_OK);
  ck_assert_int_eq(history_close(&history, &error), STATUS_OK);
  ck_assert_int_eq(history_close(&history, &error), STATUS_OK); /* closed already */
}
END_TEST

/* A run of ten rows, against one killed in the middle of the ninth and resumed from after the fifth. */
START_TEST(a_resumed_file_equals_an_uninterrupted_one) {
  Error error;
  History history;
  write_rows(&history, HISTORY_FLOW, 10);
  ck_assert_int_eq(history_close(&history, &error), STATUS_OK);
  Text whole = content();
  write_rows(&history, HISTORY_FLOW, 5);
  const long long kept = history.bytes;
  for (int k = 5; k < 8; k++) {
    const HistoryRow row = row_at(0.1 * k);
    ck_assert_int_eq(history_append(&history, &row, &error), STATUS_OK);
  }
  ck_assert_int_eq(history_close(&history, &error), STATUS_OK);
  append_bytes("0.8,0.26666");
  ck_assert_int_eq(history_resume(&history, path(), HISTORY_FLOW, kept, &error), STATUS_OK);
  for (int k = 5; k < 10; k++) {
    const HistoryRow row = row_at(0.1 * k);
    ck_assert_int_eq(history_append(&history, &row, &error), STATUS_OK);
  }
  ck_assert_int_eq(history.bytes, (long long)whole.length);
  ck_assert_int_eq(history_close(&history, &error), STATUS_OK);
  Text resumed = content();
  ck_assert_str_eq(resumed.data, whole.data);
  text_free(&whole);
  text_free(&resumed);
}
END_TEST

START_TEST(a_file_that_does_not_fit_the_snapshot_is_refused_untouched) {
  Error error;
  History history;
  write_rows(&history, HISTORY_FLOW, 3);
  const long long bytes = history.bytes;
  ck_assert_int_eq(history_close(&history, &error), STATUS_OK);
  const long long wrong[] = {
      bytes + 1, bytes - 1, bytes + 1000, 0, -1, 5, (long long)strlen(FLOW_HEADER) - 1};
  for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
    ck_assert_int_eq(history_resume(&history, path(), HISTORY_FLOW, wrong[k], &error), STATUS_IO);
    ck_assert_ptr_nonnull(strstr(error.text, "without --resume"));
    ck_assert_ptr_null(history.file);
  }
  ck_assert_int_eq(history_resume(&history, path(), HISTORY_INFLATION, bytes, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "columns"));
  Text text = content();
  ck_assert_int_eq((long long)text.length, bytes);
  text_free(&text);
  ck_assert_int_eq(history_resume(&history, scratch_path("missing.csv"), HISTORY_FLOW, bytes, &error),
                   STATUS_IO);
  ck_assert_int_eq(history_open(&history, scratch_path("no/history.csv"), HISTORY_FLOW, &error), STATUS_IO);
  ck_assert_ptr_null(history.file);
}
END_TEST

START_TEST(a_full_disk_is_an_error_with_its_cause) {
  FILE *full = fopen("/dev/full", "wb");
  if (!full) return; /* not every system has the device */
  fclose(full);
  Error error;
  History history;
  ck_assert_int_eq(history_open(&history, "/dev/full", HISTORY_FLOW, &error), STATUS_IO);
  ck_assert_ptr_nonnull(strstr(error.text, "No space left"));
}
END_TEST

int main(void) {
  if (!scratch_make()) return EXIT_FAILURE;
  int result = suite_run("history", (SuiteTests){the_columns_are_those_of_the_interface,
                                                 numbers_read_back_to_the_same_bits,
                                                 a_row_is_in_the_file_when_the_call_returns,
                                                 a_resumed_file_equals_an_uninterrupted_one,
                                                 a_file_that_does_not_fit_the_snapshot_is_refused_untouched,
                                                 a_full_disk_is_an_error_with_its_cause, NULL});
  scratch_remove();
  return result;
}
