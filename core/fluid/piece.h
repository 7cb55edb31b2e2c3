/* Loading pieces from the mesh and setting up their rules (what is done with them: piece_kernel.h). */
#ifndef CAPSELLA_FLUID_PIECE_H
#define CAPSELLA_FLUID_PIECE_H

#include "fluid/piece_kernel.h"

/* The nodes of an element in the order in which pieces are made of it: turned so that node 0 is the corner
 * that the mesh, X [n_nodes][3], tells from the other two whichever coordinates change sign.  Then what comes
 * of an element does not depend on its numbers, and what comes of its mirror image is the mirror image. */
void piece_turn(const int element[6], const double *X, int turned[6]);

/* The whole element; x, q [n_nodes][3]. */
void piece_load(const int element[6], const double *x, const double *q, Piece *piece);

/* The rule with n points, see triangle_rule. */
void piece_rule(PieceRule *rule, int n);

#endif
