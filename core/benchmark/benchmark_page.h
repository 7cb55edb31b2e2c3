/* The page of benchmarks: what is measured, in which order, and how it is told. */
#ifndef CAPSELLA_BENCHMARK_BENCHMARK_PAGE_H
#define CAPSELLA_BENCHMARK_BENCHMARK_PAGE_H

#include "base/status.h"
#include "base/text.h"
#include "benchmark/work_precision.h"
#include <mlaw/mlaw.h>
#include <stdbool.h>

typedef struct {
  bool full;                      /* finer meshes and more points: a quarter of an hour, not minutes */
  const char *folder;             /* exists; runs of whole programs leave their results in it for a while */
  const char *program;            /* path of the program itself, to measure its start */
  const mlaw_energy *compiled_in; /* the elastic law of the reference case, linked into the program */
  WorkProgress progress;          /* told what is measured next */
} BenchmarkOptions;

enum { BENCHMARK_PICTURES = 2 };
extern const char *const benchmark_picture_names[BENCHMARK_PICTURES]; /* files that the page refers to */

typedef struct {
  Text markdown, picture[BENCHMARK_PICTURES];
} BenchmarkPage;

Status benchmark_page(const BenchmarkOptions *options, BenchmarkPage *page, Error *error);
void benchmark_page_free(BenchmarkPage *page);

#endif
