/* capsella bench: run time against error on this machine, as a page of Markdown with pictures. */
#include "app/commands.h"
#include "app/help.h"
#include "base/file.h"
#include "benchmark/benchmark_page.h"
#include "observe/countdown.h"
#include <mlaw/mlaw.h>
#include <stdio.h>
#include <string.h>

/* plugins/constitutive/neo_hookean.c, linked in for comparison under this name. */
const mlaw_plugin *compiled_in_plugin(uint32_t host_minor);

/* One line with the time left on a terminal, a line for each measurement elsewhere. */
static void show(void *context, const char *line, double share) {
  Countdown *countdown = context;
  if (countdown->stream)
    countdown_show(countdown, share, 1, line);
  else
    fprintf(stderr, "capsella bench: %s\n", line);
}

static Status write_text(const char *folder, const char *name, const Text *text, Error *error) {
  Status status;
  Text path = {0};
  TRY(file_join(&path, folder, name, error));
  TRY(file_write(path.data, text->data, text->length, error));
  puts(path.data);
cleanup:
  text_free(&path);
  return status;
}

static Status bench(bool full, const char *folder, Error *error) {
  Status status;
  BenchmarkPage page = {0};
  Countdown countdown;
  const BenchmarkOptions options = {.full = full,
                                    .folder = folder,
                                    .program = "/proc/self/exe",
                                    .compiled_in = compiled_in_plugin(MLAW_ABI_MINOR)->energy[0],
                                    .progress = {show, &countdown}};
  TRY(file_make_folder(folder, error));
  countdown_start(&countdown, stderr);
  status = benchmark_page(&options, &page, error);
  countdown_clear(&countdown);
  if (status != STATUS_OK) goto cleanup;
  for (int k = 0; k < BENCHMARK_PICTURES; k++)
    TRY(write_text(folder, benchmark_picture_names[k], &page.picture[k], error));
  TRY(write_text(folder, "benchmarks.md", &page.markdown, error));
cleanup:
  benchmark_page_free(&page);
  return status;
}

int command_bench(int argc, char **argv) {
  Error error;
  bool full = false;
  const char *folder = "results/benchmarks";
  for (int i = 1; i < argc; i++) {
    if (strcmp(argv[i], "--full") == 0) {
      full = true;
    } else if (strcmp(argv[i], "-o") == 0 && i + 1 < argc) {
      folder = argv[++i];
    } else {
      return help_refuse("bench", "expected options with their values", argv[i]);
    }
  }
  const Status status = bench(full, folder, &error);
  if (status != STATUS_OK) fprintf(stderr, "%s\n", error.text);
  return exit_code(status);
}
