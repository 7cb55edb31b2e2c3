/* The surface as a tree: nested triangles (the elements of coarser meshes), the elements, and the first
 * bisections of each element, with spheres that tell from where each will do as it is.
 *
 * Every node of the tree has its point forces, by a rule on the elements or their pieces; the nested
 * triangles also have moments, which are cheaper and good enough from farther away.  Nothing is kept from one
 * update to the next. */
#ifndef CAPSELLA_FLUID_SURFACE_TREE_H
#define CAPSELLA_FLUID_SURFACE_TREE_H

#include "base/status.h"
#include "fluid/lattice.h"
#include "fluid/piece_kernel.h"
#include "mesh/mesh.h"
#include "mesh/symmetry.h"

/* When a node of the tree will do as it is. */
typedef struct {
  int rule_points; /* of the rule on elements and their pieces */
  double reach;    /* elements and pieces: for targets farther than so many radii of gyration; 0: always */
  double far;      /* moments: for targets farther than so many radii of the lattice; 0: never */
  double rough;    /* moments: where the roughness of the surface is less than this share of the distance */
} TreeScheme;

/* What nested triangles have in addition, [n] each. */
typedef struct {
  double *clear;                   /* for targets farther from the centre nothing inside is near */
  double *far2;                    /* squared: for targets farther away the moments will do */
  double *roughness;               /* largest distance of the surface from what the lattice interpolates */
  OseenBlock *moments;             /* [n][LATTICE_BLOCKS] */
  OseenRun (*run)[2];              /* points, moments */
  int (*lattice)[LATTICE_NODES];   /* mesh nodes */
  double (*weight)[LATTICE_LANES]; /* [n][CHILDREN][n_sources] */
  int n_sources;                   /* that each child hands over: points, or nodes of its own lattice */
} TreeMoments;

/* Nodes of one size.  The nodes fan * k .. fan * k + fan - 1 are the children of node k of the level above.
 */
typedef struct {
  int n, fan;
  double *center[3], *reach2; /* [n] the node will do for targets farther than this, squared */
  OseenBlock *points;         /* [n][n_blocks] */
  int n_blocks, n_points;
  TreeMoments nested;
} TreeLevel;

enum { CHILDREN_OF_PIECE = 2, TREE_BISECTIONS = 3, TREE_MAX_LEVELS = 7 + 1 + TREE_BISECTIONS };

typedef struct {
  const Mesh *mesh;
  int (*turned)[6]; /* [n_elements] nodes of the elements as pieces take them, see piece_turn */
  TreeScheme scheme;
  int n_levels, element_level;
  TreeLevel level[TREE_MAX_LEVELS];
  OseenBlock *blocks; /* [n_blocks] all that stands for an element or something larger: */
  int n_blocks;
  OseenBlock *lined_points; /* of all elements, without gaps */
  PieceRule rule;
  /* Subtrees that share nothing: those of the nodes of level 0, or fours of elements where those are level 0.
   */
  int n_roots;
  const SymmetryOperation **image; /* [n_roots] that takes it onto a subtree before it; NULL: there is none */
} SurfaceTree;

Status tree_new(SurfaceTree *tree, const Mesh *mesh, const TreeScheme *scheme, Error *error);
void tree_free(SurfaceTree *tree);

/* From now on x and q have this symmetry, which must outlive the tree: subtrees that are images of others are
 * not computed but reflected. */
void tree_use_symmetry(SurfaceTree *tree, const Symmetry *symmetry);

/* Elements and nested triangles at positions x with load q, both [n_nodes][3]. */
void tree_update(SurfaceTree *tree, const double *x, const double *q);

/* The pieces of element e, which are not used before. */
void tree_cut(SurfaceTree *tree, int e, const double *x, const double *q);

#endif
