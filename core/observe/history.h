/* history.csv: one row per sample of a run, with numbers that read back to the same bits.
 *
 * A row is written with one call and never buffered beyond it, so a process that dies leaves whole rows and
 * at most one cut-off row at the end.  A snapshot keeps `History.bytes`; history_resume cuts the file back to
 * it. */
#ifndef CAPSELLA_OBSERVE_HISTORY_H
#define CAPSELLA_OBSERVE_HISTORY_H

#include "base/status.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Dimensionless: lengths by a, time by 1/rate, tensions by G_s.  NAN is written as `nan`. */
typedef struct {
  double t;
  double D12, beta, L1, L2, L3;        /* Shape: beta in radians, L full axis lengths */
  double area_strain;                  /* (S - S0)/S0 */
  double volume_error;                 /* V/V0 - 1 */
  double d_max, Y_max, T1_max, T2_min; /* over the integration points */
  double compressed_area;              /* share of the area at rest where T2 < 0 */
  double wrinkle_amplitude;            /* of waves on the scale of the mesh (observe/wrinkles.h) */
  double elastic_energy, dissipated_energy, energy_error;
  double step;           /* size of the last accepted step */
  long long evaluations; /* velocity evaluations so far */
  double p, d, alpha;    /* HISTORY_INFLATION only: surface averages of load and damage, imposed radius */
} HistoryRow;

typedef enum { HISTORY_FLOW, HISTORY_INFLATION } HistoryKind; /* inflation adds the columns p, d, alpha */

/* The columns: how many, their names, their values in a row as doubles. */
size_t history_columns(HistoryKind kind);
const char *history_column(size_t column);
double history_value(const HistoryRow *row, size_t column);

typedef struct {
  FILE *file; /* NULL: closed */
  HistoryKind kind;
  long long bytes; /* length of the file after the last whole row: what a snapshot keeps */
} History;

/* Whether a history of some kind has a column of this name. */
bool history_has_column(const char *name);

/* Makes (or empties) the file and writes the header line; on failure it is left closed. */
Status history_open(History *history, const char *path, HistoryKind kind, Error *error);

/* Opens the file a stopped run left and cuts it to its first `bytes` bytes.  STATUS_IO when the file is
 * missing, shorter than that, of other columns, or when byte `bytes` does not end a row. */
Status history_resume(History *history, const char *path, HistoryKind kind, long long bytes, Error *error);

Status history_append(History *history, const HistoryRow *row, Error *error);

/* Waits until the rows are on the disk: call before the snapshot that keeps `bytes` is written. */
Status history_sync(History *history, Error *error);

/* Syncs and closes; nothing to do when it is closed already. */
Status history_close(History *history, Error *error);

#endif
