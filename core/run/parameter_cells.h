/* Parameters that vary over the membrane, as data of the cells of a snapshot: `elastic_NAME`, `damage_NAME`.
 */
#ifndef CAPSELLA_RUN_PARAMETER_CELLS_H
#define CAPSELLA_RUN_PARAMETER_CELLS_H

#include "base/status.h"
#include "observe/snapshot.h"
#include "run/simulation.h"

typedef struct {
  SnapshotCells *cells; /* [n]; names and values are owned */
  size_t n;
} ParameterCells;

Status parameter_cells_new(ParameterCells *cells, const Simulation *simulation, Error *error);
void parameter_cells_free(ParameterCells *cells);

#endif
