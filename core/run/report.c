#include "run/report.h"

#include "base/file.h"
#include "observe/picture.h"
#include "run/output.h"
#include "run/record.h"
#include "run/run_page.h"
#include "run/simulation.h"

static Status draw(Output *output, const Simulation *s, const Record *record, Text *svg, Error *error) {
  output_nodal_fields(output, s);
  const bool damaged = material_has_damage(&s->material);
  const Picture picture = {
      .mesh = &s->mesh,
      .x = record->x,
      .field = damaged ? output->d : output->Y,
      .label = damaged ? "damage d" : "energy release rate Y / G_s",
      .views = picture_shear_views,
      .n_views = 2,
      .axes = picture_shear_axes,
      .n_axes = 3,
  };
  return picture_print(&picture, svg, error);
}

Status report_folder(const char *folder, Text *written, Error *error) {
  Status status = STATUS_OK;
  Text scene_path = {0}, svg = {0};
  Scene scene = {0};
  Simulation simulation = {0};
  Record record = {0};
  Output output = {0};
  int number;
  TRY(file_join(&scene_path, folder, "resolved.yaml", error));
  TRY(scene_read(&scene, scene_path.data, NULL, 0, error));
  TRY(simulation_new(&simulation, &scene, NULL, error));
  TRY(record_new(&record, &simulation, error));
  TRY(output_open(&output, folder, &simulation, error));
  TRY(output_restore(&output, &simulation, &record, NULL, &number, error));
  if (number < 0) {
    status =
        error_set(error, STATUS_INPUT, "%s: expected a snapshot of a run, found none that is whole", folder);
    goto cleanup;
  }
  TRY(record_begin(&record, true, error));
  TRY(draw(&output, &simulation, &record, &svg, error));
  TRY(file_join(written, folder, "capsule.svg", error));
  TRY(file_write(written->data, svg.data, svg.length, error));
  TRY(run_page_write(folder, NULL, error));
  TRY(text_append(written, error, "\n%s/report.html", folder));
cleanup:
  output_close(&output);
  record_free(&record);
  simulation_free(&simulation);
  scene_free(&scene);
  text_free(&svg);
  text_free(&scene_path);
  return status;
}
