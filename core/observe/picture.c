/* Layout and ink; what is seen comes from the projection.  Coordinates of the surface are whole tenths of a
 * pixel, which keeps the file short. */
#include "observe/picture.h"

#include "base/array.h"
#include "base/vec3.h"
#include "observe/palette.h"
#include "observe/projection.h"
#include "observe/svg.h"
#include <math.h>
#include <stdbool.h>

const PictureView picture_shear_views[2] = {
    {{0, -1, 0}, {0, 0, 1}, "along the vorticity axis", false},
    {{0, 0, 1}, {0, 1, 0}, "along the velocity gradient", false},
};
const PictureAxis picture_shear_axes[3] = {
    {{1, 0, 0}, "flow"}, {{0, 0, 1}, "gradient"}, {{0, 1, 0}, "vorticity"}};

enum {
  VIEW_SIZE = 380,   /* pixels of the square of one view */
  TITLE_HEIGHT = 30, /* above the views */
  HEIGHT = TITLE_HEIGHT + VIEW_SIZE,
  BAR_WIDTH = 110, /* right of them, with its labels */
  LEGEND_WIDTH = 250,
  CUTS_MAX = 4,
  PIECES_WANTED = 12000,
};
static const double FILLING = 0.78; /* part of a view's width that the capsule takes at most */

typedef struct {
  double center[2][3];     /* of the boxes around the capsule and, with a view of it, around that at rest */
  double scale;            /* pixels per length: the capsule fits however it is turned */
  double minimum, maximum; /* of the colour bar, with a field */
  int cuts;                /* of an element's edge */
} Frame;

/* --- colours --- */

static const unsigned char plain[3] = {150, 170, 190};

static unsigned color_of(const Picture *picture, const Frame *frame, const Piece *piece) {
  double rgb[3] = {plain[0], plain[1], plain[2]};
  if (picture->field) palette_color((piece->value - frame->minimum) / (frame->maximum - frame->minimum), rgb);
  /* Shade and a faint gloss show the form, even where the map is dark; the field stays legible. */
  const double shade = 0.65 + 0.35 * piece->light, gloss = 0.25 * pow(piece->light, 6);
  unsigned color = 0;
  for (int c = 0; c < 3; c++)
    color = color << 8 | (unsigned)lround(shade * rgb[c] + gloss * (255 - shade * rgb[c]));
  return color;
}

/* --- the frame --- */

/* values [n_nodes][components] */
static Status check_finite(const double *values, int n_nodes, int components, const char *what,
                           Error *error) {
  for (int k = 0; k < n_nodes * components; k++)
    if (!isfinite(values[k]))
      return error_set(error, STATUS_INPUT, "picture: expected a finite %s, found %g at node %d", what,
                       values[k], k / components);
  return STATUS_OK;
}

static int cuts_for(const Picture *picture) {
  const double seen = 0.5 * (double)picture->n_views * picture->mesh->n_elements; /* half face away */
  const int cuts = (int)sqrt(PIECES_WANTED / fmax(seen, 1));
  return cuts < 1 ? 1 : cuts > CUTS_MAX ? CUTS_MAX : cuts;
}

/* The range given, else that of the field; widened where it is no more than round-off. */
static void range_of(const Picture *picture, double *minimum, double *maximum) {
  *minimum = picture->minimum;
  *maximum = picture->maximum;
  if (!(*maximum > *minimum)) {
    *minimum = HUGE_VAL;
    *maximum = -HUGE_VAL;
    for (int p = 0; p < picture->mesh->n_nodes; p++) {
      *minimum = fmin(*minimum, picture->field[p]);
      *maximum = fmax(*maximum, picture->field[p]);
    }
  }
  const double size = fmax(fabs(*minimum), fabs(*maximum));
  if (*maximum - *minimum <= 1e-9 * size) *maximum = *minimum + fmax(size, 1);
}

static const double *positions_of(const Picture *picture, bool is_reference) {
  return is_reference ? picture->X : picture->x;
}

/* The centre of the box around the capsule; returns the largest distance from it. */
static double measure(const double *x, int n_nodes, double center[3]) {
  double half_width = 0;
  for (int i = 0; i < 3; i++) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int p = 0; p < n_nodes; p++) {
      low = fmin(low, x[3 * p + i]);
      high = fmax(high, x[3 * p + i]);
    }
    center[i] = 0.5 * (low + high);
  }
  for (int p = 0; p < n_nodes; p++) half_width = fmax(half_width, vec3_distance(x + 3 * p, center));
  return half_width;
}

static void frame_of(const Picture *picture, Frame *frame) {
  *frame = (Frame){.cuts = cuts_for(picture)};
  double half_width = 0;
  for (size_t k = 0; k < picture->n_views; k++) {
    const bool is_reference = picture->views[k].is_reference;
    half_width = fmax(half_width, measure(positions_of(picture, is_reference), picture->mesh->n_nodes,
                                          frame->center[is_reference]));
  }
  frame->scale = 0.5 * FILLING * VIEW_SIZE / half_width;
  if (picture->field) range_of(picture, &frame->minimum, &frame->maximum);
}

/* --- drawing --- */

static Status print_piece(Text *svg, const Piece *piece, double scale, unsigned color, Error *error) {
  long p[3][2];
  for (int k = 0; k < 3; k++) {
    p[k][0] = lround(10 * (0.5 * VIEW_SIZE + scale * piece->corner[k][0]));
    p[k][1] = lround(10 * (0.5 * VIEW_SIZE - scale * piece->corner[k][1]));
  }
  return text_append(svg, error, "<path color=\"#%06x\" d=\"M%ld %ld %ld %ld %ld %ldz\"/>\n", color, p[0][0],
                     p[0][1], p[1][0], p[1][1], p[2][0], p[2][1]);
}

/* The capsule in the square of one view.  A stroke of each piece's own colour closes the hair lines between
 * neighbours. */
static Status print_capsule(const Picture *picture, const Frame *frame, bool is_reference,
                            const Projection *projection, Text *svg, Error *error) {
  Status status;
  Piece *pieces = NULL;
  size_t count;
  TRY(projection_pieces(projection, picture->mesh, positions_of(picture, is_reference), picture->field,
                        frame->center[is_reference], frame->cuts, &pieces, &count, error));
  TRY(text_append(svg, error,
                  "<g transform=\"scale(.1)\" fill=\"currentColor\" stroke=\"currentColor\" "
                  "stroke-width=\"6\" stroke-linejoin=\"round\">\n"));
  for (size_t k = 0; k < count; k++)
    TRY(print_piece(svg, &pieces[k], frame->scale, color_of(picture, frame, &pieces[k]), error));
  TRY(text_append(svg, error, "</g>\n"));
cleanup:
  array_free(pieces);
  return status;
}

/* Pixels of a mark in its view; false when it is on the far side. */
static bool place_mark(const PictureMark *mark, const Frame *frame, bool is_reference,
                       const Projection *projection, double at[2]) {
  double arm[3];
  vec3_subtract(is_reference ? mark->X : mark->x, frame->center[is_reference], arm);
  at[0] = 0.5 * VIEW_SIZE + frame->scale * vec3_dot(arm, projection->right);
  at[1] = 0.5 * VIEW_SIZE - frame->scale * vec3_dot(arm, projection->up);
  return vec3_dot(arm, projection->toward) >= -1e-9 * vec3_norm(arm);
}

/* The dots of a view: the first mark seen near a place leads those that fall together with it. */
typedef struct {
  double at[2];
  bool is_near, is_seen;
  size_t leader;
} Dot;

static void gather_dots(const Picture *picture, const Frame *frame, bool is_reference,
                        const Projection *projection, Dot *dots) {
  enum { TOGETHER = 10 };
  for (size_t k = 0; k < picture->n_marks; k++) {
    dots[k].is_near = place_mark(&picture->marks[k], frame, is_reference, projection, dots[k].at);
    dots[k].is_seen = dots[k].is_near || picture->marks_shine_through;
    dots[k].leader = k;
    for (size_t i = 0; i < k && dots[k].leader == k; i++)
      if (dots[i].is_seen && dots[i].leader == i &&
          hypot(dots[i].at[0] - dots[k].at[0], dots[i].at[1] - dots[k].at[1]) < TOGETHER)
        dots[k].leader = i;
  }
}

static Status print_dot(const Picture *picture, const Dot *dots, size_t leader, Text *svg, Error *error) {
  Status status = STATUS_OK;
  Text label = {0};
  const double *at = dots[leader].at;
  for (size_t k = leader; k < picture->n_marks; k++)
    if (dots[k].is_seen && dots[k].leader == leader)
      TRY(text_append(&label, error, "%s%s", k > leader ? " " : "", picture->marks[k].label));
  TRY(text_append(
      svg, error,
      "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" fill=\"#d43\" stroke=\"#fff\" stroke-width=\"1.5\"%s/>\n",
      at[0], at[1], dots[leader].is_near ? "" : " opacity=\"0.6\""));
  TRY(svg_label(svg, at[0] + 7, at[1] - 5, "start", label.data, error));
cleanup:
  text_free(&label);
  return status;
}

static Status print_marks(const Picture *picture, const Frame *frame, bool is_reference,
                          const Projection *projection, Text *svg, Error *error) {
  Status status = STATUS_OK;
  Dot *dots = NULL;
  TRY(ARRAY_NEW(&dots, picture->n_marks, error));
  gather_dots(picture, frame, is_reference, projection, dots);
  TRY(text_append(svg, error, "<g class=\"mark\">\n"));
  for (size_t k = 0; k < picture->n_marks; k++)
    if (dots[k].is_seen && dots[k].leader == k) TRY(print_dot(picture, dots, k, svg, error));
  TRY(text_append(svg, error, "</g>\n"));
cleanup:
  array_free(dots);
  return status;
}

/* One axis from the corner of a view: an arrow, or a ring with a dot (toward the eye) or cross (away). */
static Status print_axis(const PictureAxis *axis, const Projection *projection, Text *svg, Error *error) {
  enum { CORNER = 48, LENGTH = 40, RING = 6 };
  double direction[3] = {axis->direction[0], axis->direction[1], axis->direction[2]};
  vec3_normalize(direction);
  const double right = vec3_dot(direction, projection->right), down = -vec3_dot(direction, projection->up);
  const double x0 = CORNER, y0 = VIEW_SIZE - CORNER, length = hypot(right, down);
  Status status;
  if (length < 0.1) {
    const bool is_toward = vec3_dot(direction, projection->toward) > 0;
    TRY(text_append(svg, error, "<circle cx=\"%g\" cy=\"%g\" r=\"%d\" fill=\"#fff\"/>\n", x0, y0, RING));
    TRY(text_append(svg, error,
                    is_toward ? "<circle cx=\"%g\" cy=\"%g\" r=\"1.5\" fill=\"#333\"/>\n"
                              : "<path transform=\"translate(%g %g)\" d=\"M-4 -4L4 4M-4 4L4 -4\"/>\n",
                    x0, y0));
    return svg_label(svg, x0 - RING, y0 + RING + 14, "middle", axis->label, error);
  }
  const double x1 = x0 + LENGTH * right, y1 = y0 + LENGTH * down;
  const double along[2] = {right / length, down / length};
  TRY(text_append(svg, error, "<path d=\"M%.1f %.1fL%.1f %.1f\"/>\n", x0, y0, x1, y1));
  TRY(text_append(svg, error, "<path fill=\"#333\" d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fz\"/>\n",
                  x1 + 7 * along[0], y1 + 7 * along[1], x1 - 3 * along[1], y1 + 3 * along[0],
                  x1 + 3 * along[1], y1 - 3 * along[0]));
  TRY(svg_label(svg, x1 + 12 * along[0], y1 + 12 * along[1] + 4, right > 0.5 ? "start" : "middle",
                axis->label, error));
cleanup:
  return status;
}

static Status print_view(const Picture *picture, const Frame *frame, const PictureView *view, size_t index,
                         Text *svg, Error *error) {
  Status status;
  Projection projection;
  TRY(projection_make(&projection, view->toward, view->up, error));
  TRY(text_append(svg, error, "<g transform=\"translate(%zu %d)\">\n", index * VIEW_SIZE, TITLE_HEIGHT));
  if (view->title) TRY(svg_label(svg, 0.5 * VIEW_SIZE, -8, "middle", view->title, error));
  TRY(print_capsule(picture, frame, view->is_reference, &projection, svg, error));
  TRY(text_append(svg, error, "<g stroke=\"#333\">\n"));
  for (size_t k = 0; k < picture->n_axes; k++) TRY(print_axis(&picture->axes[k], &projection, svg, error));
  TRY(text_append(svg, error, "</g>\n"));
  TRY(print_marks(picture, frame, view->is_reference, &projection, svg, error));
  TRY(text_append(svg, error, "</g>\n"));
cleanup:
  return status;
}

static Status print_legend(const Picture *picture, Text *svg, Error *error) {
  enum { LINE = 19, TOP = 60 };
  const size_t left = picture->n_views * VIEW_SIZE + (picture->field ? BAR_WIDTH : 0) + 10;
  Status status = STATUS_OK;
  for (size_t k = 0; k < picture->n_legend; k++)
    TRY(svg_label(svg, (double)left, TOP + LINE * (double)k, "start", picture->legend[k], error));
cleanup:
  return status;
}

/* --- the colour bar --- */

static Status print_bar(const Picture *picture, const Frame *frame, Text *svg, Error *error) {
  enum { LEFT = 15, WIDTH = 16, TOP = 60, LENGTH = VIEW_SIZE - 80 };
  Status status;
  const double range = frame->maximum - frame->minimum, step = svg_tick_step(range, 5);
  TRY(palette_gradient("map", svg, error));
  TRY(text_append(svg, error, "<g transform=\"translate(%zu 0)\" stroke=\"#333\">\n",
                  picture->n_views * VIEW_SIZE + LEFT));
  TRY(text_append(svg, error, "<rect y=\"%d\" width=\"%d\" height=\"%d\" fill=\"url(#map)\"/>\n", TOP, WIDTH,
                  LENGTH));
  if (picture->label) TRY(svg_label(svg, 0, TOP - 14, "start", picture->label, error));
  for (double k = ceil(frame->minimum / step); k * step <= frame->maximum; k++) {
    const double y = TOP + LENGTH * (frame->maximum - k * step) / range;
    TRY(text_append(svg, error, "<path d=\"M%d %.1fh5\"/>\n", WIDTH, y));
    TRY(svg_number(svg, WIDTH + 9, y + 4, "start", k * step, error));
  }
  TRY(text_append(svg, error, "</g>\n"));
cleanup:
  return status;
}

Status picture_print(const Picture *picture, Text *svg, Error *error) {
  Status status = STATUS_OK;
  Frame frame;
  const size_t width = picture->n_views * VIEW_SIZE + (picture->field ? BAR_WIDTH : 0) +
                       (picture->n_legend > 0 ? LEGEND_WIDTH : 0);
  for (size_t k = 0; k < picture->n_views; k++)
    TRY(check_finite(positions_of(picture, picture->views[k].is_reference), picture->mesh->n_nodes, 3,
                     "position", error));
  if (picture->field) TRY(check_finite(picture->field, picture->mesh->n_nodes, 1, "field value", error));
  frame_of(picture, &frame);
  TRY(text_append(
      svg, error,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %zu %d\" width=\"%zu\" height=\"%d\">\n"
      "<style>text{font:13px sans-serif;fill:#222;stroke:none}"
      ".mark text{paint-order:stroke;stroke:#fff;stroke-width:3;stroke-opacity:.75}</style>\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
      width, HEIGHT, width, HEIGHT));
  for (size_t k = 0; k < picture->n_views; k++)
    TRY(print_view(picture, &frame, &picture->views[k], k, svg, error));
  if (picture->field) TRY(print_bar(picture, &frame, svg, error));
  TRY(print_legend(picture, svg, error));
  TRY(text_append(svg, error, "</svg>\n"));
cleanup:
  return status;
}
