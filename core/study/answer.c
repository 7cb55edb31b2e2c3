#include "study/answer.h"

void answer_header(Table *table, const char *name) {
  static const char *const parts[] = {"low", "high", "error", "runs", "note"};
  table_text(table, name);
  for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) table_component(table, name, parts[i]);
}

void answer_put(Table *table, const Answer *answer) {
  table_number(table, answer->value);
  table_number(table, answer->low);
  table_number(table, answer->high);
  table_number(table, answer->error);
  table_number(table, answer->runs);
  table_text(table, answer->note);
}
