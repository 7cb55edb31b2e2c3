/* table.csv: rows of text and numbers under one header line. */
#ifndef CAPSELLA_STUDY_TABLE_H
#define CAPSELLA_STUDY_TABLE_H

#include "study/runner.h"

/* Errors stick: calls after the first failure do nothing, and table_write tells it. */
typedef struct {
  Text text;
  bool in_row;
  Status status;
  Error *error;
} Table;

void table_begin(Table *table, Error *error);
void table_text(Table *table, const char *value);
void table_number(Table *table, double value);                          /* empty when it is not finite */
void table_component(Table *table, const char *name, const char *axis); /* a header "name_axis" */
void table_end_row(Table *table);

/* The varied keys and their values. */
void table_axes_header(Table *table, const Study *study);
void table_axes(Table *table, const Study *study, size_t point);

/* How a case ended, and its figures: the same columns in every study. */
void table_case_header(Table *table);
void table_case(Table *table, const Case *item);

/* Whether one of these columns is a figure of this name, found in the case's summary under the same. */
bool table_has_figure(const char *name);

/* Writes FOLDER/NAME and frees the table. */
Status table_write(Table *table, const char *folder, const char *name);

#endif
