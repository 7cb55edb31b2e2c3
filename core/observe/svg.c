#include "observe/svg.h"

#include <math.h>
#include <stdbool.h>

static const char *entity(char c) {
  switch (c) {
  case '&':
    return "&amp;";
  case '<':
    return "&lt;";
  case '>':
    return "&gt;";
  case '"':
    return "&quot;";
  default:
    return NULL;
  }
}

Status svg_escape(Text *svg, const char *string, Error *error) {
  Status status = STATUS_OK;
  for (const char *s = string; *s && status == STATUS_OK; s++)
    status = entity(*s) ? text_append(svg, error, "%s", entity(*s)) : text_append_bytes(svg, error, s, 1);
  return status;
}

static Status open_text(Text *svg, double x, double y, const char *anchor, Error *error) {
  return text_append(svg, error, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor);
}

Status svg_label(Text *svg, double x, double y, const char *anchor, const char *label, Error *error) {
  Status status;
  TRY(open_text(svg, x, y, anchor, error));
  TRY(svg_escape(svg, label, error));
  TRY(text_append(svg, error, "</text>\n"));
cleanup:
  return status;
}

Status svg_number(Text *svg, double x, double y, const char *anchor, double value, Error *error) {
  const double size = fabs(value);
  const bool is_plain = value == 0 || (size > 0.999e-3 && size < 0.999e5);
  const int exponent = is_plain ? 0 : (int)floor(log10(size) + 1e-9);
  const double digits = value / pow(10, exponent) + 0.0; /* no -0 */
  Status status;
  TRY(open_text(svg, x, y, anchor, error));
  if (is_plain)
    TRY(text_append(svg, error, "%g</text>\n", digits));
  else if (fabs(digits - 1) < 1e-9)
    TRY(text_append(svg, error, "10"));
  else
    TRY(text_append(svg, error, "%g·10", digits));
  if (!is_plain)
    TRY(text_append(svg, error, "<tspan dy=\"-5\" font-size=\"75%%\">%d</tspan></text>\n", exponent));
cleanup:
  return status;
}

double svg_tick_step(double range, double count) {
  const double power = pow(10, floor(log10(range / count)));
  const double ratio = range / count / power;
  return power * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
}
