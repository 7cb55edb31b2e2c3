/* Level by level and without branches: which nodes are near is as good as random to the processor.  The order
 * of the sums depends on the surface and the target only. */
#include "fluid/walk.h"

#include "fluid/piece.h"
#include "fluid/tree_kernel.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

/* Bisections of an element: pieces 1/2^16 of its length, smaller than any distance that a mesh resolves. */
enum { MAX_BISECTIONS = 32 };

/* Parents whose children are looked at in one go. */
enum { BATCH = 64, MAX_LOOKED_AT = BATCH * CHILDREN };

typedef struct {
  const SurfaceTree *tree;
  const double *x, *q;
  int p;
  Gather *gather;
  WalkCount *count;
} Walk;

/* Looks at the children of n <= BATCH nested triangles, themselves nested triangles: gathers those that will
 * do, by moments or points, and lists the others in near[].  Returns how many. */
static int look_at_nested(Walk *walk, const TreeLevel *level, const int *parent, int n, int *near) {
  double distance2[MAX_LOOKED_AT];
  OseenRun *run = gather_room(walk->gather, MAX_LOOKED_AT);
  int n_runs = 0, n_near = 0, n_far = 0;
  tree_distances(level->center, CHILDREN, parent, n, walk->gather->target, distance2);
  for (int i = 0; i < CHILDREN * n; i++) {
    int k = CHILDREN * parent[i / CHILDREN] + i % CHILDREN;
    int is_far = distance2[i] > level->nested.far2[k], will_do = distance2[i] > level->reach2[k];
    run[n_runs] = level->nested.run[k][is_far];
    near[n_near] = k;
    n_runs += will_do;
    n_near += !will_do;
    n_far += is_far;
  }
  gather_used(walk->gather, n_runs);
  walk->count->far += LATTICE_NODES * n_far + level->n_points * (n_runs - n_far);
  return n_near;
}

static int holds_node(const int element[6], int p) {
  return (element[0] == p) | (element[1] == p) | (element[2] == p) | (element[3] == p) | (element[4] == p) |
         (element[5] == p);
}

/* The same when the children are elements or pieces; elements around the target are left out. */
static int look_at_pieces(Walk *walk, const TreeLevel *level, const int *parent, int n, int *near) {
  const bool elements = level->fan == CHILDREN;
  const int fan = elements ? CHILDREN : CHILDREN_OF_PIECE;
  double distance2[MAX_LOOKED_AT];
  OseenRun *run = gather_room(walk->gather, MAX_LOOKED_AT);
  int n_runs = 0, n_near = 0;
  tree_distances(level->center, fan, parent, n, walk->gather->target, distance2);
  for (int i = 0; i < fan * n; i++) {
    int k = fan * parent[i / fan] + i % fan;
    int counts = elements ? !holds_node(walk->tree->mesh->element[k], walk->p) : 1;
    int will_do = distance2[i] >= level->reach2[k];
    run[n_runs].first = &level->points[(size_t)k * level->n_blocks];
    run[n_runs].n = level->n_blocks;
    near[n_near] = k;
    n_runs += will_do & counts;
    n_near += (1 - will_do) & counts;
  }
  gather_used(walk->gather, n_runs);
  *(elements ? &walk->count->far : &walk->count->near) += level->n_points * n_runs;
  return n_near;
}

/* Piece k of element k >> depth after `depth` bisections. */
static void cut_out(const Walk *walk, int k, int depth, Piece *piece) {
  if (depth == 0) {
    piece_load(walk->tree->turned[k], walk->x, walk->q, piece);
    return;
  }
  Piece parent, other;
  cut_out(walk, k / 2, depth - 1, &parent);
  if (k % 2 == 0) {
    piece_bisect(&parent, piece, &other);
  } else {
    piece_bisect(&parent, &other, piece);
  }
}

/* Cuts a piece, already bisected `depth` times, and its halves until each part will do. */
static void cut_on(Walk *walk, const Piece *piece, int depth) {
  const PieceRule *rule = &walk->tree->rule;
  Piece half[2];
  piece_bisect(piece, &half[0], &half[1]);
  for (int i = 0; i < 2; i++) {
    const double *target = walk->gather->target;
    double center[3], reach2 = piece_reach2(&half[i], walk->tree->scheme.reach, center);
    double r0 = center[0] - target[0], r1 = center[1] - target[1], r2 = center[2] - target[2];
    if (r0 * r0 + r1 * r1 + r2 * r2 >= reach2 || depth + 1 == MAX_BISECTIONS) {
      piece_points(&half[i], rule, gather_reserve(walk->gather, rule->n_blocks));
      walk->count->near += rule->n;
    } else {
      cut_on(walk, &half[i], depth + 1);
    }
  }
}

/* Goes on below n near pieces, bisected `depth` times, which have no children in the tree. */
static void leave_tree(Walk *walk, const int *piece, int n, int depth) {
  for (int i = 0; i < n; i++) {
    Piece parent;
    cut_out(walk, piece[i], depth, &parent);
    cut_on(walk, &parent, depth);
  }
}

/* Goes on from n near nodes of the level above, down to the elements. */
static void walk_down(Walk *walk, int l, const int *parent, int n, NearElements *listed) {
  const SurfaceTree *tree = walk->tree;
  const TreeLevel *level = &tree->level[l];
  for (int first = 0; first < n; first += BATCH) {
    int near[MAX_LOOKED_AT], length = n - first < BATCH ? n - first : BATCH;
    if (l < tree->element_level) {
      walk_down(walk, l + 1, near, look_at_nested(walk, level, parent + first, length, near), listed);
      continue;
    }
    int n_near = look_at_pieces(walk, level, parent + first, length, near);
    int fit = n_near < NEAR_LISTED - listed->n ? n_near : NEAR_LISTED - listed->n;
    memcpy(listed->element + listed->n, near, fit * sizeof *near);
    listed->n += fit;
    leave_tree(walk, near + fit, n_near - fit, 0);
  }
}

void walk_far(const SurfaceTree *tree, const double *x, const double *q, int p, Gather *gather,
              NearElements *near, WalkCount *count) {
  Walk walk = {.tree = tree, .x = x, .q = q, .p = p, .gather = gather, .count = count};
  int n = tree->level[0].n / CHILDREN; /* as if the level above the top were all near */
  near->n = 0;
  for (int first = 0; first < n; first += BATCH) {
    int parent[BATCH], length = n - first < BATCH ? n - first : BATCH;
    for (int i = 0; i < length; i++) parent[i] = first + i;
    walk_down(&walk, 0, parent, length, near);
  }
}

/* Goes on from n near elements or pieces of the level above. */
static void walk_pieces(Walk *walk, int l, const int *parent, int n) {
  const SurfaceTree *tree = walk->tree;
  if (l == tree->n_levels) {
    leave_tree(walk, parent, n, l - 1 - tree->element_level);
    return;
  }
  for (int first = 0; first < n; first += BATCH) {
    int near[MAX_LOOKED_AT], length = n - first < BATCH ? n - first : BATCH;
    walk_pieces(walk, l + 1, near, look_at_pieces(walk, &tree->level[l], parent + first, length, near));
  }
}

void walk_near(const SurfaceTree *tree, const double *x, const double *q, const NearElements *near,
               Gather *gather, WalkCount *count) {
  Walk walk = {.tree = tree, .x = x, .q = q, .p = -1, .gather = gather, .count = count};
  walk_pieces(&walk, tree->element_level + 1, near->element, near->n);
}
