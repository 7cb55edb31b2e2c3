/* snapshot_NNNNNN.vtkhdf: the state of a run in one file, for ParaView and for a restart.
 *
 * The file is HDF5.  `/VTKHDF` is an UnstructuredGrid of quadratic triangles whose points are the current
 * positions x; `/restart` holds named arrays that the run needs to go on, and the resolved scene.  The first
 * 512 bytes (an HDF5 user block) hold the format version, the length and a checksum of all that follows, and
 * are checked before HDF5 sees a byte: a cut-off or altered file is refused, never half read. */
#ifndef CAPSELLA_OBSERVE_SNAPSHOT_H
#define CAPSELLA_OBSERVE_SNAPSHOT_H

#include "base/log.h"
#include "base/status.h"
#include "base/text.h"
#include "mesh/mesh.h"
#include <stddef.h>

/* A field at the nodes, [n_nodes][components]; components 1 or 3. */
typedef struct {
  const char *name;
  int components;
  const double *values;
} SnapshotField;

/* Values at the elements, [n_elements]. */
typedef struct {
  const char *name;
  const double *values;
} SnapshotCells;

/* One named array of the restart group: written from here, and read back into the same place, so that one
 * list serves both ways.  Exactly one of the two pointers is set; a scalar has count 1. */
typedef struct {
  const char *name; /* unique in the list; no '/' */
  size_t count;
  double *doubles;
  long long *integers;
} RestartItem;

typedef struct {
  const Mesh *mesh;
  double t;
  const double *x; /* [n_nodes][3]; x and (from the mesh) X become fields by themselves */
  const SnapshotField *fields;
  size_t n_fields;
  const SnapshotCells *cells; /* the same in every snapshot of a series */
  size_t n_cells;
  const RestartItem *restart;
  size_t n_restart;
  const char *scene; /* the resolved scene as YAML */
} Snapshot;

/* "folder/snapshot_000042.vtkhdf" for number 42, appended to `path`. */
Status snapshot_path(Text *path, const char *folder, int number, Error *error);

/* Writes under a temporary name, syncs and renames: readers see the whole file or none. */
Status snapshot_write(const char *path, const Snapshot *snapshot, Error *error);

/* Fills the items from the file; none is touched before all have been checked.  STATUS_IO: missing, cut-off,
 * altered, of another format version.  STATUS_INPUT: whole, but an item is missing, of another type or of
 * another count, or the file holds one that is not in the list: it belongs to another scene. */
Status snapshot_read_restart(const char *path, const RestartItem *items, size_t n_items, Error *error);

/* A field as found in a file: its name, and values [n_nodes][components]. */
typedef struct {
  char name[32];
  int components;
  double *values;
} GridField;

enum { GRID_MAX_FIELDS = 16 };

/* The surface that a snapshot shows, its positions X and x among the fields. */
typedef struct {
  double t;
  int n_nodes, n_elements;
  int (*element)[6]; /* [n_elements], as in mesh.h */
  GridField field[GRID_MAX_FIELDS];
  size_t n_fields;
} SnapshotGrid;

/* STATUS_IO: missing, cut-off, altered, of another format version, or not of this shape. */
Status snapshot_read_grid(const char *path, SnapshotGrid *grid, Error *error);
void snapshot_grid_free(SnapshotGrid *grid);

/* The field of that name, or NULL. */
const GridField *snapshot_grid_find(const SnapshotGrid *grid, const char *name);

/* The resolved scene (appended to `scene`) and the time; either may be NULL. */
Status snapshot_read_scene(const char *path, Text *scene, double *t, Error *error);

/* Numbers of the snapshots in a folder by their names, rising, whole or not; freed with array_free. */
Status snapshot_list(const char *folder, int **numbers, size_t *count, Error *error);

/* The newest whole snapshot of a folder: its path appended to `path` and its number; number is -1 when the
 * folder has no snapshot.  A newer one that is damaged is skipped with a warning in the log (may be NULL);
 * STATUS_IO when all are. */
Status snapshot_find_newest(const char *folder, Text *path, int *number, Log *log, Error *error);

#endif
