/* The summary as JSON; the figures come from the run. */
#include "observe/summary.h"

#include "base/file.h"
#include "observe/json.h"

const char *outcome_name(Outcome outcome) {
  static const char *const name[] = {"steady", "end", "ruptured", "failed", "interrupted"};
  return name[outcome];
}

static void put_places(Json *json, const double X[3], const double x[3]) {
  json_numbers(json, "X", X, 3);
  json_numbers(json, "x", x, 3);
}

static void put_shape(Json *json, const Summary *summary) {
  json_number(json, "D12", summary->D12);
  json_number(json, "beta", summary->beta);
  json_number(json, "L1", summary->L1);
  json_number(json, "L2", summary->L2);
  json_number(json, "L3", summary->L3);
  json_number(json, "area_strain", summary->area_strain);
  json_number(json, "volume_error", summary->volume_error);
  json_number(json, "volume_error_max", summary->volume_error_max);
}

static void put_damage(Json *json, const Summary *summary) {
  json_number(json, "d_max", summary->d_max);
  if (summary->d_max > 0) {
    json_open_object(json, "d_max_location");
    put_places(json, summary->d_max_location.X, summary->d_max_location.x);
    json_close(json);
  } else {
    json_null(json, "d_max_location");
  }
  json_number(json, "Y_max", summary->Y_max);
  json_number(json, "t_c", summary->t_c);
  json_number(json, "t_l", summary->t_l);
  if (!summary->has_rupture) {
    json_null(json, "rupture");
    return;
  }
  json_open_object(json, "rupture");
  put_places(json, summary->rupture.X, summary->rupture.x);
  json_number(json, "angle_to_vorticity_deg", summary->rupture.angle_to_vorticity_deg);
  json_number(json, "angle_to_major_axis_deg", summary->rupture.angle_to_major_axis_deg);
  json_number(json, "damaged_area_fraction", summary->damaged_area_fraction);
  json_close(json);
}

static void put_cost(Json *json, const Summary *summary) {
  json_integer(json, "steps", summary->steps);
  json_integer(json, "rejected_steps", summary->rejected_steps);
  json_integer(json, "evaluations", summary->evaluations);
  json_integer(json, "stage_evaluations", summary->stage_evaluations);
  json_number(json, "wall_seconds", summary->wall_seconds);
  json_integer(json, "threads", summary->threads);
  json_integer(json, "elements", summary->elements);
  json_integer(json, "nodes", summary->nodes);
}

/* The physical values of a scene with units, in SI. */
static void put_physical(Json *json, const Summary *summary) {
  const double a = summary->length_scale, time = summary->time_scale, G = summary->tension_scale;
  if (a == 0) return;
  json_open_object(json, "physical");
  json_number(json, "radius_m", a);
  json_number(json, "time_scale_s", time);
  json_number(json, "shear_modulus_N_per_m", G);
  json_number(json, "t_s", summary->t * time);
  json_number(json, "L1_m", summary->L1 * a);
  json_number(json, "L2_m", summary->L2 * a);
  json_number(json, "L3_m", summary->L3 * a);
  json_number(json, "Y_max_N_per_m", summary->Y_max * G);
  json_number(json, "t_c_s", summary->t_c * time);
  json_number(json, "t_l_s", summary->t_l * time);
  json_close(json);
}

Status summary_print(const Summary *summary, Text *text, Error *error) {
  Json json;
  json_begin(&json, text, error);
  json_open_object(&json, NULL);
  json_string(&json, "status", outcome_name(summary->status));
  json_number(&json, "t", summary->t);
  put_shape(&json, summary);
  put_damage(&json, summary);
  json_number(&json, "energy_error_max", summary->energy_error_max);
  json_number(&json, "step_error_max", summary->step_error_max);
  json_number(&json, "film_min", summary->film_min);
  json_number(&json, "wrinkle_amplitude_max", summary->wrinkle_amplitude_max);
  json_integer(&json, "unstable_steps", summary->unstable_steps);
  put_cost(&json, summary);
  put_physical(&json, summary);
  if (summary->n_criteria > 0) verdicts_print_json(summary->criteria, summary->n_criteria, &json);
  json_open_array(&json, "skipped");
  for (size_t k = 0; k < summary->n_skipped; k++) json_string(&json, NULL, summary->skipped[k]);
  json_close(&json);
  json_close(&json);
  return json_end(&json);
}

Status summary_write(const Summary *summary, const char *path, Error *error) {
  Text text = {0};
  Status status = summary_print(summary, &text, error);
  if (status == STATUS_OK) status = file_write(path, text.data, text.length, error);
  text_free(&text);
  return status;
}
