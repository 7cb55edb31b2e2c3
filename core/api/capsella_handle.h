/* What a handle of the C interface holds. */
#ifndef CAPSELLA_API_CAPSELLA_HANDLE_H
#define CAPSELLA_API_CAPSELLA_HANDLE_H

#include "api/capsella.h"
#include "base/log.h"
#include "base/text.h"
#include "config/scene.h"
#include "run/nodal_fields.h"
#include "run/record.h"
#include "run/simulation.h"
#include <stdbool.h>

struct Capsella {
  CapsellaState state;
  Error error;   /* the text is "" as long as nothing has failed */
  Error failure; /* BROKEN: of the step */
  char **set;    /* [n_sets] "key=value" */
  size_t n_sets;
  Log log; /* into log_text, which stdio allocates */
  char *log_text;
  size_t log_length;
  /* Unless CLOSED: */
  Scene scene;
  Simulation simulation;
  Record record;
  /* Readings of the accepted state at these times; NAN: none yet. */
  double row_t, nodal_t;
  HistoryRow row;
  NodalFields nodal;
};

/* Keeps the message; USAGE where the caller is to blame. */
CapsellaStatus handle_refuse(Capsella *capsella, const char *format, ...) PRINTF_LIKE(2, 3);

/* OK when a scene is open. */
CapsellaStatus handle_need_scene(Capsella *capsella);

/* What a status of the engine is to the caller. */
CapsellaStatus handle_result(Status status);

/* Puts the record's probe at the accepted state. */
Status handle_look(Capsella *capsella);

#endif
