/* Each piece is cut to a polygon; an edge that two polygons share runs there and back, and goes.  What is
 * left is chained into loops: as many edges leave a point as arrive there, so every trail closes. */
#include "observe/outline.h"

#include "base/array.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  long x, y;
} Point;

typedef struct {
  Point from, to;
  bool is_gone;
} Edge;

typedef struct {
  Edge *edge; /* [count] */
  size_t count;
} Edges;

static int compare_points(Point a, Point b) {
  if (a.x != b.x) return a.x < b.x ? -1 : 1;
  return (a.y > b.y) - (a.y < b.y);
}

static bool is_same(Point a, Point b) {
  return a.x == b.x && a.y == b.y;
}

/* ---- Polygons ---- */

static Point corner_of(const Piece *piece, int k, double scale) {
  return (Point){lround(scale * piece->corner[k][0]), lround(-scale * piece->corner[k][1])};
}

/* Where the level lies between corners i and k: the same point for the piece on the other side of the edge.
 */
static Point cut(const Piece *piece, int i, int k, double level, double scale) {
  if (compare_points(corner_of(piece, i, scale), corner_of(piece, k, scale)) > 0) {
    const int swap = i;
    i = k;
    k = swap;
  }
  const double u = (level - piece->values[i]) / (piece->values[k] - piece->values[i]);
  double at[2];
  for (int c = 0; c < 2; c++) at[c] = piece->corner[i][c] + u * (piece->corner[k][c] - piece->corner[i][c]);
  return (Point){lround(scale * at[0]), lround(-scale * at[1])};
}

/* The part of a piece where the field is at least the level: number of its corners, at most 4. */
static int polygon(const Piece *piece, double level, double scale, Point corner[4]) {
  int n = 0;
  for (int k = 0; k < 3; k++) {
    const int next = (k + 1) % 3;
    const bool is_in = piece->values[k] >= level;
    if (is_in) corner[n++] = corner_of(piece, k, scale);
    if (is_in != (piece->values[next] >= level)) corner[n++] = cut(piece, k, next, level, scale);
  }
  return n;
}

static void add_polygon(Edges *edges, const Point *corner, int n) {
  for (int k = 0; k < n; k++)
    if (!is_same(corner[k], corner[(k + 1) % n]))
      edges->edge[edges->count++] = (Edge){.from = corner[k], .to = corner[(k + 1) % n]};
}

/* ---- Cancelling ---- */

static Point low_end(const Edge *edge) {
  return compare_points(edge->from, edge->to) < 0 ? edge->from : edge->to;
}
static Point high_end(const Edge *edge) {
  return compare_points(edge->from, edge->to) < 0 ? edge->to : edge->from;
}

static int by_place(const void *a, const void *b) {
  const Edge *left = a, *right = b;
  const int low = compare_points(low_end(left), low_end(right));
  return low ? low : compare_points(high_end(left), high_end(right));
}

static int by_start(const void *a, const void *b) {
  const Edge *left = a, *right = b;
  const int start = compare_points(left->from, right->from);
  return start ? start : compare_points(left->to, right->to);
}

/* Of the edges at one place, those that run one way go with as many that run the other way. */
static void cancel_place(Edge *edge, size_t n) {
  for (size_t i = 0; i < n; i++)
    for (size_t k = i + 1; k < n && !edge[i].is_gone; k++)
      if (!edge[k].is_gone && is_same(edge[i].from, edge[k].to)) edge[i].is_gone = edge[k].is_gone = true;
}

static void cancel(Edges *edges) {
  qsort(edges->edge, edges->count, sizeof *edges->edge, by_place);
  for (size_t first = 0, last; first < edges->count; first = last) {
    for (last = first + 1; last < edges->count; last++)
      if (by_place(&edges->edge[first], &edges->edge[last]) != 0) break;
    cancel_place(edges->edge + first, last - first);
  }
  size_t left = 0;
  for (size_t k = 0; k < edges->count; k++)
    if (!edges->edge[k].is_gone) edges->edge[left++] = edges->edge[k];
  edges->count = left;
  qsort(edges->edge, edges->count, sizeof *edges->edge, by_start);
}

/* ---- Chaining ---- */

/* The first edge from this point that has not been walked, or NULL. */
static Edge *edge_from(const Edges *edges, Point point) {
  size_t low = 0, high = edges->count;
  while (low < high) {
    const size_t middle = (low + high) / 2;
    if (compare_points(edges->edge[middle].from, point) < 0)
      low = middle + 1;
    else
      high = middle;
  }
  for (; low < edges->count && is_same(edges->edge[low].from, point); low++)
    if (!edges->edge[low].is_gone) return &edges->edge[low];
  return NULL;
}

/* Whether the way goes on in the direction it came. */
static bool is_straight(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x);
}

static Status print_step(Point from, Point to, Text *path, Error *error) {
  const long y = to.y - from.y;
  return text_append(path, error, "%ld%s%ld ", to.x - from.x, y < 0 ? "" : " ", y);
}

/* Points in the middle of a straight way are left out. */
static Status print_loop(const Edges *edges, Edge *edge, Text *path, Error *error) {
  Status status;
  Point corner = edge->from, here = edge->to;
  TRY(text_append(path, error, "M%ld %ldl", corner.x, corner.y));
  for (edge->is_gone = true; (edge = edge_from(edges, here)); edge->is_gone = true) {
    if (!is_straight(corner, here, edge->to)) {
      TRY(print_step(corner, here, path, error));
      corner = here;
    }
    here = edge->to;
  }
  TRY(text_append(path, error, "z"));
cleanup:
  return status;
}

Status outline_print(const Piece *pieces, size_t count, double level, double scale, Text *path,
                     Error *error) {
  Status status;
  Edges edges = {0};
  TRY(ARRAY_NEW(&edges.edge, 4 * count, error));
  for (size_t k = 0; k < count; k++) {
    Point corner[4];
    add_polygon(&edges, corner, polygon(&pieces[k], level, scale, corner));
  }
  cancel(&edges);
  for (size_t k = 0; k < edges.count; k++)
    if (!edges.edge[k].is_gone) TRY(print_loop(&edges, &edges.edge[k], path, error));
cleanup:
  array_free(edges.edge);
  return status;
}
