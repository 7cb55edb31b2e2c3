/* Distances of a target from many nodes of the tree. */
#ifndef CAPSELLA_FLUID_TREE_KERNEL_H
#define CAPSELLA_FLUID_TREE_KERNEL_H

/* Squared distances of the target from the centres of nodes fan * parent[i] + c, c < fan, for i < n, in that
 * order.  fan is 2 or 4; center [3][...]. */
void tree_distances(double *const center[3], int fan, const int *parent, int n, const double target[3],
                    double *distance2);

#endif
