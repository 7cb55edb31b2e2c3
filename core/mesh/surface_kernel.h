/* Normal vectors, areas and moments of P2 elements, one lane per element. */
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

/* Area of each element. */
void surface_block_areas(const P2Table *table, SurfaceBlock x, double area[SURFACE_LANES]);

/* Integrals over each element of (y . n) {1/3; y_i/4; y_i y_j/5} with y = x - origin: volume, first and
 * second moments of what they enclose together, in the order of SurfaceMoments. */
enum { SURFACE_MOMENTS = 10 };
void surface_block_moments(const P2Table *table, SurfaceBlock x, const double origin[3],
                           double moment[SURFACE_MOMENTS][SURFACE_LANES]);

#endif
