/* A chart as SVG: series of points as lines or marks over linear or logarithmic axes, with a legend.
 *
 * One file, no script, no font but the viewer's own; it follows the light or dark scheme of its reader.
 * Colours are told apart by colour-blind eyes, marks also by their form.  Several charts may stand in one
 * page. */
#ifndef CAPSELLA_OBSERVE_CHART_H
#define CAPSELLA_OBSERVE_CHART_H

#include "base/status.h"
#include "base/text.h"
#include <stdbool.h>
#include <stddef.h>

typedef enum { CHART_LINE, CHART_DASHES, CHART_MARKS, CHART_LINE_AND_MARKS } ChartStyle;

/* A value that is not finite, or not above 0 on a logarithmic axis, is left out and breaks the line. */
typedef struct {
  const char *label; /* in the legend; NULL: not there */
  const double *x;   /* [n] */
  const double *y;   /* [n] */
  size_t n;
  ChartStyle style;
  int color, mark; /* from 1, over again past 7 and 6; 0: by the place in the list of series */
} ChartSeries;

/* A ring around a point and words beside it. */
typedef struct {
  double x, y;
  const char *label; /* may be NULL */
} ChartPoint;

typedef struct {
  const char *label; /* may be NULL */
  bool logarithmic;
  double minimum, maximum; /* what is outside is cut off; equal: the range of the data, to whole ticks */
} ChartAxis;

typedef struct {
  const char *title; /* may be NULL */
  ChartAxis x, y;
  const ChartSeries *series;
  size_t n_series;
  const ChartPoint *points; /* highlighted */
  size_t n_points;
} Chart;

/* Appends a whole SVG document.  STATUS_INPUT: nothing to draw, or a range that a logarithmic axis cannot
 * show. */
Status chart_print(const Chart *chart, Text *svg, Error *error);

#endif
