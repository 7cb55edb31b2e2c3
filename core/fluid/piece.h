/* Loading pieces from the mesh and setting up their rules (what is done with them: piece_kernel.h). */
#ifndef CAPSELLA_FLUID_PIECE_H
#define CAPSELLA_FLUID_PIECE_H

#include "fluid/piece_kernel.h"

/* The whole element; x, q [n_nodes][3]. */
void piece_load(const int element[6], const double *x, const double *q, Piece *piece);

/* The rule with n points, see triangle_rule. */
void piece_rule(PieceRule *rule, int n);

#endif
