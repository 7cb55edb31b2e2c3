/* The C interface: a handle from scene to end.  Reading is in capsella_read.c. */
#include "api/capsella_handle.h"

#include "base/array.h"
#include "run/march.h"
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *capsella_version(void) {
  return CAPSELLA_VERSION;
}

/* ---- handle ---- */

Capsella *capsella_new(void) {
  Error ignored;
  Capsella *capsella = array_allocate(1, sizeof *capsella, "handle", &ignored);
  if (!capsella) return NULL;
  capsella->log.quiet = true;
  capsella->log.file = open_memstream(&capsella->log_text, &capsella->log_length);
  if (capsella->log.file) return capsella;
  array_free(capsella);
  return NULL;
}

static void close_scene(Capsella *capsella) {
  nodal_fields_free(&capsella->nodal);
  record_free(&capsella->record);
  simulation_free(&capsella->simulation);
  scene_free(&capsella->scene);
  capsella->state = CAPSELLA_CLOSED;
}

void capsella_free(Capsella *capsella) {
  if (!capsella) return;
  close_scene(capsella);
  for (size_t i = 0; i < capsella->n_sets; i++) array_free(capsella->set[i]);
  array_free(capsella->set);
  log_close(&capsella->log);
  free(capsella->log_text);
  array_free(capsella);
}

CapsellaStatus handle_refuse(Capsella *capsella, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  vsnprintf(capsella->error.text, sizeof capsella->error.text, format, arguments);
  va_end(arguments);
  return CAPSELLA_USAGE;
}

CapsellaStatus handle_need_scene(Capsella *capsella) {
  if (capsella->state != CAPSELLA_CLOSED) return CAPSELLA_OK;
  return handle_refuse(capsella, "expected an open scene, found none: see capsella_open_file");
}

CapsellaStatus handle_result(Status status) {
  switch (status) {
  case STATUS_OK:
    return CAPSELLA_OK;
  case STATUS_INPUT:
    return CAPSELLA_INPUT;
  case STATUS_IO:
    return CAPSELLA_IO;
  case STATUS_MEMORY:
    return CAPSELLA_MEMORY;
  case STATUS_REJECT:
  case STATUS_FAILED:
    break;
  }
  return CAPSELLA_FAILED;
}

const char *capsella_error(const Capsella *capsella) {
  return capsella ? capsella->error.text : "out of memory";
}

const char *capsella_log(const Capsella *capsella) {
  return capsella->log_text ? capsella->log_text : "";
}

CapsellaState capsella_state(const Capsella *capsella) {
  return capsella->state;
}

double capsella_time(const Capsella *capsella) {
  return capsella->state == CAPSELLA_CLOSED ? 0 : capsella->simulation.motion->t;
}

/* ---- opening ---- */

static CapsellaStatus refuse_second_scene(Capsella *capsella) {
  return handle_refuse(capsella, "a scene is open already: another one needs a handle of its own");
}

static Status append_set(Capsella *capsella, char *setting, Error *error) {
  char **longer = array_allocate(capsella->n_sets + 1, sizeof *longer, "settings", error);
  if (!longer) return error->code;
  if (capsella->n_sets > 0) memcpy(longer, capsella->set, capsella->n_sets * sizeof *longer);
  array_free(capsella->set);
  capsella->set = longer;
  capsella->set[capsella->n_sets++] = setting;
  return STATUS_OK;
}

CapsellaStatus capsella_set(Capsella *capsella, const char *key, const char *value) {
  Status status = STATUS_OK;
  Error *error = &capsella->error;
  Text setting = {0};
  if (capsella->state != CAPSELLA_CLOSED) return refuse_second_scene(capsella);
  TRY(text_append(&setting, error, "%s=%s", key, value));
  TRY(append_set(capsella, setting.data, error));
  setting = (Text){0};
cleanup:
  text_free(&setting);
  return handle_result(status);
}

static void finish_at_end(Capsella *capsella) {
  const bool is_over = capsella->simulation.motion->t >= capsella->scene.time.end;
  capsella->state = is_over ? CAPSELLA_END : CAPSELLA_RUNNING;
}

/* The scene has been read. */
static Status begin(Capsella *capsella) {
  Status status = STATUS_OK;
  Error *error = &capsella->error;
  Simulation *s = &capsella->simulation;
  TRY(simulation_new(s, &capsella->scene, &capsella->log, error));
  TRY(record_new(&capsella->record, s, error));
  TRY(nodal_fields_new(&capsella->nodal, s, error));
  TRY(simulation_start(s, error));
  TRY(record_begin(&capsella->record, false, error));
  TRY(march_renew_load(&capsella->record, s->motion->t, error));
  capsella->row_t = capsella->nodal_t = NAN;
  finish_at_end(capsella);
cleanup:
  return status;
}

typedef struct {
  const char *file, *text; /* text: NULL to read the file */
} Source;

static Status read_and_begin(Capsella *capsella, Source source) {
  Status status;
  const char *const *sets = (const char *const *)capsella->set;
  Error *error = &capsella->error;
  if (source.text)
    TRY(scene_read_text(&capsella->scene, source.file, source.text, strlen(source.text), sets,
                        capsella->n_sets, error));
  else
    TRY(scene_read(&capsella->scene, source.file, sets, capsella->n_sets, error));
  TRY(begin(capsella));
cleanup:
  if (status != STATUS_OK) close_scene(capsella);
  return status;
}

/* In the C locale, for this thread alone: the caller's may write a comma where a scene has a point. */
static CapsellaStatus open_source(Capsella *capsella, Source source) {
  if (capsella->state != CAPSELLA_CLOSED) return refuse_second_scene(capsella);
  const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
  if (plain == (locale_t)0) return handle_result(error_set(&capsella->error, STATUS_MEMORY, "out of memory"));
  const locale_t callers = uselocale(plain);
  const Status status = read_and_begin(capsella, source);
  uselocale(callers);
  freelocale(plain);
  return handle_result(status);
}

CapsellaStatus capsella_open_file(Capsella *capsella, const char *path) {
  return open_source(capsella, (Source){.file = path});
}

CapsellaStatus capsella_open_text(Capsella *capsella, const char *name, const char *text) {
  return open_source(capsella, (Source){.file = name, .text = text});
}

/* ---- stepping ---- */

Status handle_look(Capsella *capsella) {
  return record_probe(&capsella->record, capsella->simulation.motion->t, &capsella->error);
}

/* Rates are watched from step to step. */
static Status watch_steady(Capsella *capsella) {
  Status status = STATUS_OK;
  HistoryRow row;
  Shape shape;
  if (!(capsella->scene.stop.steady > 0)) return STATUS_OK;
  TRY(handle_look(capsella));
  TRY(record_row(&capsella->record, &row, &shape, &capsella->error));
  march_watch_steady(&capsella->record, &row);
cleanup:
  return status;
}

static Status step_to(Capsella *capsella, double t) {
  Status status = STATUS_OK;
  Record *record = &capsella->record;
  bool ruptured;
  TRY(march_propose(record, fmin(t, capsella->scene.time.end), &capsella->log, &ruptured, &capsella->error));
  TRY(march_accept(record, &capsella->error));
  TRY(watch_steady(capsella));
  finish_at_end(capsella);
  if (ruptured)
    capsella->state = CAPSELLA_RUPTURED;
  else if (capsella->state == CAPSELLA_RUNNING && march_is_steady(record))
    capsella->state = CAPSELLA_STEADY;
cleanup:
  return status;
}

/* After a failure the last accepted state stays readable, and every call to go on fails as the first did. */
static Status go_on(Capsella *capsella, double t) {
  Error ignored;
  if (capsella->state == CAPSELLA_BROKEN) {
    capsella->error = capsella->failure;
    return capsella->failure.code;
  }
  const Status status = step_to(capsella, t);
  if (status == STATUS_OK) return STATUS_OK;
  capsella->state = CAPSELLA_BROKEN;
  capsella->failure = capsella->error;
  march_fall_back(&capsella->record, &ignored);
  return status;
}

CapsellaStatus capsella_step(Capsella *capsella) {
  if (handle_need_scene(capsella) != CAPSELLA_OK) return CAPSELLA_USAGE;
  const bool is_over = capsella->state != CAPSELLA_RUNNING && capsella->state != CAPSELLA_BROKEN;
  return is_over ? CAPSELLA_OK : handle_result(go_on(capsella, INFINITY));
}

CapsellaStatus capsella_advance(Capsella *capsella, double t) {
  if (handle_need_scene(capsella) != CAPSELLA_OK) return CAPSELLA_USAGE;
  if (isnan(t)) return handle_refuse(capsella, "expected a time to advance to, found %g", t);
  Status status = STATUS_OK;
  if (capsella->state == CAPSELLA_BROKEN) status = go_on(capsella, t);
  while (status == STATUS_OK && capsella->state == CAPSELLA_RUNNING && capsella_time(capsella) < t)
    status = go_on(capsella, t);
  return handle_result(status);
}
