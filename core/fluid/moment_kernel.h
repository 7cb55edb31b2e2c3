/* Clusters of elements seen from afar: their point forces moved to a lattice of 15 of their own nodes.
 *
 * A force at y becomes 15 forces at the lattice nodes x_k, so weighted that sum w_k(y) J(x, x_k) interpolates
 * J(x, y) as a smooth function on the surface. */
#ifndef CAPSELLA_FLUID_MOMENT_KERNEL_H
#define CAPSELLA_FLUID_MOMENT_KERNEL_H

#include "fluid/oseen_kernel.h"

enum { LATTICE_NODES = 15, LATTICE_BLOCKS = 2, LATTICE_LANES = LATTICE_BLOCKS * OSEEN_LANES };

/* Moves the first n forces of `from` to the lattice: moments[k].f += sum over i of weight[i][k] from[i].f.
 * Returns the largest squared distance between a y_i and its interpolated place, sum over k of weight[i][k]
 * x_k: how far the surface is from being smooth on the scale of the lattice. */
double moment_add(const double weight[][LATTICE_LANES], int n, const OseenBlock *from, OseenBlock *moments);

#endif
