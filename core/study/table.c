/* CSV as in RFC 4180, with bare line ends; numbers as short as they read back. */
#include "study/table.h"

#include "base/file.h"
#include "observe/number.h"
#include <math.h>
#include <string.h>

static void put(Table *table, const char *bytes, size_t length) {
  if (table->status == STATUS_OK)
    table->status = text_append_bytes(&table->text, table->error, bytes, length);
}

static void begin_cell(Table *table) {
  if (table->in_row) put(table, ",", 1);
  table->in_row = true;
}

void table_begin(Table *table, Error *error) {
  *table = (Table){.error = error};
}

void table_text(Table *table, const char *value) {
  begin_cell(table);
  if (!value) return;
  if (!strpbrk(value, ",\"\n\r")) {
    put(table, value, strlen(value));
    return;
  }
  put(table, "\"", 1);
  for (const char *c = value; *c; c++) put(table, *c == '"' ? "\"\"" : c, *c == '"' ? 2 : 1);
  put(table, "\"", 1);
}

void table_number(Table *table, double value) {
  char digits[NUMBER_SIZE] = "";
  begin_cell(table);
  if (isfinite(value)) number_print(value, digits);
  put(table, digits, strlen(digits));
}

void table_component(Table *table, const char *name, const char *axis) {
  begin_cell(table);
  put(table, name, strlen(name));
  put(table, "_", 1);
  put(table, axis, strlen(axis));
}

void table_end_row(Table *table) {
  put(table, "\n", 1);
  table->in_row = false;
}

void table_axes_header(Table *table, const Study *study) {
  for (size_t a = 0; a < study->n_axes; a++) table_text(table, study->axes[a].key);
}

void table_axes(Table *table, const Study *study, size_t point) {
  size_t stride = study->n_points;
  for (size_t a = 0; a < study->n_axes; a++) {
    stride /= study->axes[a].n;
    table_text(table, study->axes[a].values[point / stride % study->axes[a].n].value);
  }
}

static const char *const FIGURES[] = {"t",
                                      "D12",
                                      "beta",
                                      "L1",
                                      "L2",
                                      "L3",
                                      "area_strain",
                                      "volume_error_max",
                                      "d_max",
                                      "Y_max",
                                      "t_c",
                                      "t_l",
                                      "energy_error_max",
                                      "steps",
                                      "evaluations"};
static const char *const RUPTURE[] = {"angle_to_vorticity_deg", "angle_to_major_axis_deg",
                                      "damaged_area_fraction"};
static const char *const AXES[] = {"1", "2", "3"};
enum { N_FIGURES = sizeof FIGURES / sizeof *FIGURES, N_RUPTURE = sizeof RUPTURE / sizeof *RUPTURE };

bool table_has_figure(const char *name) {
  for (int i = 0; i < N_FIGURES; i++)
    if (strcmp(FIGURES[i], name) == 0) return true;
  return false;
}

void table_case_header(Table *table) {
  table_text(table, "case");
  table_text(table, "status");
  for (int i = 0; i < N_FIGURES; i++) table_text(table, FIGURES[i]);
  for (int k = 0; k < 3; k++) table_component(table, "rupture_X", AXES[k]);
  for (int k = 0; k < 3; k++) table_component(table, "rupture_x", AXES[k]);
  for (int i = 0; i < N_RUPTURE; i++) table_text(table, RUPTURE[i]);
  table_text(table, "reason");
}

void table_case(Table *table, const Case *item) {
  static const char *const keys[N_RUPTURE] = {
      "rupture.angle_to_vorticity_deg", "rupture.angle_to_major_axis_deg", "rupture.damaged_area_fraction"};
  table_text(table, item->label);
  table_text(table, case_ended(item) ? case_status(item) : "not run");
  for (int i = 0; i < N_FIGURES; i++) table_number(table, case_number(item, FIGURES[i]));
  for (size_t k = 0; k < 3; k++) table_number(table, case_component(item, "rupture.X", k));
  for (size_t k = 0; k < 3; k++) table_number(table, case_component(item, "rupture.x", k));
  for (int i = 0; i < N_RUPTURE; i++) table_number(table, case_number(item, keys[i]));
  table_text(table, item->reason);
}

Status table_write(Table *table, const char *folder, const char *name) {
  Text path = {0};
  Status status = table->status;
  if (status == STATUS_OK) status = file_join(&path, folder, name, table->error);
  if (status == STATUS_OK) status = file_write(path.data, table->text.data, table->text.length, table->error);
  text_free(&path);
  text_free(&table->text);
  return status;
}
