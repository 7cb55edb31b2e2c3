#include "observe/verdict.h"

#include "base/file.h"
#include "base/text.h"
#include "observe/number.h"
#include <math.h>

const char *verdict_name(const Finding *finding) {
  if (!isnan(finding->t_l)) return "ruptured";
  return isnan(finding->t_c) ? "whole" : "damaged";
}

/* ---- JSON ---- */

static void put_site(Json *json, const char *key, const Site *site, const char *value_key, double value) {
  json_open_object(json, key);
  if (value_key) json_number(json, value_key, value);
  json_numbers(json, "X", site->X, 3);
  json_numbers(json, "x", site->x, 3);
  json_number(json, "angle_to_vorticity_deg", site->angle_to_vorticity_deg);
  json_number(json, "angle_to_major_axis_deg", site->angle_to_major_axis_deg);
  json_close(json);
}

static void put_verdict(Json *json, const Verdict *verdict) {
  const Finding *f = &verdict->finding;
  json_open_object(json, NULL);
  json_string(json, "name", verdict->name);
  json_string(json, "law", verdict->law);
  json_string(json, "status", verdict_name(f));
  json_number(json, "t_c", f->t_c);
  json_number(json, "t_l", f->t_l);
  json_number(json, "d_max", f->d_max);
  json_number(json, "t", f->t);
  if (f->d_max > 0)
    put_site(json, "site", &f->site, NULL, 0);
  else
    json_null(json, "site");
  json_number(json, "damaged_area_fraction", f->damaged_area_fraction);
  put_site(json, "thinnest", &f->thinnest, "thickness", f->thickness_min);
  put_site(json, "tensest", &f->tensest, "T1", f->T1_max);
  json_close(json);
}

void verdicts_print_json(const Verdict *verdicts, size_t n, Json *json) {
  json_open_array(json, "criteria");
  for (size_t i = 0; i < n; i++) put_verdict(json, &verdicts[i]);
  json_close(json);
}

/* ---- CSV ---- */

static Status append_numbers(Text *text, const double *values, int count, Error *error) {
  char digits[NUMBER_SIZE];
  Status status = STATUS_OK;
  for (int i = 0; i < count; i++) {
    number_print(values[i], digits);
    TRY(text_append(text, error, ",%s", digits));
  }
cleanup:
  return status;
}

static const char HEADER[] =
    "criterion,law,status,t_c,t_l,d_max,t,X1,X2,X3,x1,x2,x3,angle_to_vorticity_deg,angle_to_major_axis_deg,"
    "damaged_area_fraction,thickness_min,thinnest_angle_to_vorticity_deg,thinnest_angle_to_major_axis_deg,"
    "T1_max,tensest_angle_to_vorticity_deg,tensest_angle_to_major_axis_deg\n";

/* A sound membrane has no place of largest damage. */
static Site known_site(const Finding *f) {
  if (f->d_max > 0) return f->site;
  return (Site){{NAN, NAN, NAN}, {NAN, NAN, NAN}, NAN, NAN};
}

static Status append_row(Text *text, const Verdict *verdict, Error *error) {
  const Finding *f = &verdict->finding;
  const Site site = known_site(f);
  const double times[] = {f->t_c, f->t_l, f->d_max, f->t};
  const double rest[] = {site.angle_to_vorticity_deg,
                         site.angle_to_major_axis_deg,
                         f->damaged_area_fraction,
                         f->thickness_min,
                         f->thinnest.angle_to_vorticity_deg,
                         f->thinnest.angle_to_major_axis_deg,
                         f->T1_max,
                         f->tensest.angle_to_vorticity_deg,
                         f->tensest.angle_to_major_axis_deg};
  Status status = STATUS_OK;
  TRY(text_append(text, error, "%s,%s,%s", verdict->name, verdict->law, verdict_name(f)));
  TRY(append_numbers(text, times, 4, error));
  TRY(append_numbers(text, site.X, 3, error));
  TRY(append_numbers(text, site.x, 3, error));
  TRY(append_numbers(text, rest, sizeof rest / sizeof *rest, error));
  TRY(text_append(text, error, "\n"));
cleanup:
  return status;
}

Status verdicts_write(const Verdict *verdicts, size_t n, const char *path, Error *error) {
  Text text = {0};
  Status status = STATUS_OK;
  TRY(text_append(&text, error, "%s", HEADER));
  for (size_t i = 0; i < n; i++) TRY(append_row(&text, &verdicts[i], error));
  TRY(file_write(path, text.data, text.length, error));
cleanup:
  text_free(&text);
  return status;
}
