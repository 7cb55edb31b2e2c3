/* Vectors of P2 elements that are normal to them, one lane per element. */
#ifndef CAPSELLA_MESH_SURFACE_KERNEL_H
#define CAPSELLA_MESH_SURFACE_KERNEL_H

#include "mesh/p2.h"

enum { SURFACE_LANES = 16 };

/* Component i of local node k of each element. */
typedef double SurfaceBlock[6][3][SURFACE_LANES];

/* int N_k a_1 x a_2 dxi deta at node k, by the rule of the table. */
void surface_block_area_vectors(const P2Table *table, SurfaceBlock x, SurfaceBlock A);

/* a_1 x a_2 at node k; the table holds the shape functions at the nodes. */
void surface_block_normals(const P2Table *table, SurfaceBlock x, SurfaceBlock normal);

#endif
