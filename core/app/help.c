/* Help and usage lines from the table of commands, and the way through it. */
#include "app/help.h"
#include "app/commands.h"
#include <stdio.h>
#include <string.h>

#undef help_refuse /* what the analyzer is told */

enum { WIDTH = 90, MOST_NAMES = 64, DEEPEST_COLUMN = 28 };

/* ---- Finding ---- */

const HelpPage *help_page(const char *name) {
  for (size_t i = 0; i < N_HELP_PAGES; i++)
    if (strcmp(HELP_PAGES[i].name, name) == 0) return &HELP_PAGES[i];
  return NULL;
}

const HelpPage *help_find(int n, char *const *words) {
  char name[64];
  if (n >= 2 && snprintf(name, sizeof name, "%s %s", words[0], words[1]) < (int)sizeof name) {
    const HelpPage *page = help_page(name);
    if (page) return page;
  }
  return help_page(n >= 1 ? words[0] : "");
}

const char *help_word(const HelpPage *page) {
  const char *blank = strrchr(page->name, ' ');
  return blank ? blank + 1 : page->name;
}

bool help_is_below(const HelpPage *page, const char *parent) {
  const size_t length = strlen(parent);
  const char *word = help_word(page);
  if (length == 0) return word == page->name && *word;
  return word == page->name + length + 1 && strncmp(page->name, parent, length) == 0;
}

const char *help_nearest(const char *parent, const char *word) {
  const char *names[MOST_NAMES];
  size_t n = 0;
  for (size_t i = 0; i < N_HELP_PAGES && n < MOST_NAMES; i++)
    if (help_is_below(&HELP_PAGES[i], parent)) names[n++] = help_word(&HELP_PAGES[i]);
  return text_nearest(word, names, n);
}

static const char *nearest_option(const HelpPage *page, const char *found) {
  const char *names[HELP_OPTIONS + 1] = {"--help"};
  size_t n = 1;
  for (const HelpOption *option = page->options; !help_option_ends(option); option++)
    if (option->flag) names[n++] = option->flag;
  return text_nearest(found, names, n);
}

/* ---- Usage ---- */

/* "[--set KEY=VALUE]..." */
static Status print_use(const HelpOption *option, Text *text, Error *error) {
  return text_append(text, error, "%s%s%s%s%s%s", option->required ? "" : "[",
                     option->flag ? option->flag : "", option->flag && option->value ? " " : "",
                     option->value ? option->value : "", option->required ? "" : "]",
                     option->repeats ? "..." : "");
}

Status help_print_usage(const HelpPage *page, Text *text, Error *error) {
  Status status;
  Text use = {0};
  const size_t start = text->length;
  TRY(text_append(text, error, "usage: capsella%s%s", *page->name ? " " : "", page->name));
  const size_t indent = text->length - start;
  size_t column = indent;
  for (const HelpOption *option = page->options; !help_option_ends(option); option++) {
    use.length = 0;
    TRY(print_use(option, &use, error));
    if (column + 1 + use.length > WIDTH) {
      TRY(text_append(text, error, "\n%*s", (int)indent, ""));
      column = indent;
    }
    TRY(text_append(text, error, " %s", use.data));
    column += 1 + use.length;
  }
  TRY(text_append(text, error, "\n"));
cleanup:
  text_free(&use);
  return status;
}

/* ---- Help ---- */

/* Words in lines that begin at `indent`; the first line is at `column` already. */
static Status print_wrapped(const char *words, size_t length, size_t column, size_t indent, Text *text,
                            Error *error) {
  Status status = STATUS_OK;
  const char *end = words + length, *separator = "";
  while (words < end) {
    const char *blank = memchr(words, ' ', (size_t)(end - words));
    const size_t word = (size_t)((blank ? blank : end) - words);
    if (*separator && column + 1 + word > WIDTH) {
      TRY(text_append(text, error, "\n%*s", (int)indent, ""));
      column = indent;
      separator = "";
    }
    TRY(text_append(text, error, "%s%.*s", separator, (int)word, words));
    column += strlen(separator) + word;
    separator = " ";
    words += word + 1;
  }
  TRY(text_append(text, error, "\n"));
cleanup:
  return status;
}

/* Two columns; a name too long for the first has a line of its own. */
static Status print_entry(const char *name, const char *about, size_t width, Text *text, Error *error) {
  Status status;
  const size_t indent = width + 4;
  TRY(text_append(text, error, "  %-*s  ", (int)width, name));
  if (strlen(name) > width) TRY(text_append(text, error, "\n%*s", (int)indent, ""));
  TRY(print_wrapped(about, strlen(about), indent, indent, text, error));
cleanup:
  return status;
}

static void option_name(const HelpOption *option, char name[64]) {
  snprintf(name, 64, "%s%s%s", option->flag ? option->flag : "", option->flag && option->value ? " " : "",
           option->value ? option->value : "");
}

static size_t options_width(const HelpPage *page) {
  char name[64];
  size_t width = 8;
  for (const HelpOption *option = page->options; !help_option_ends(option); option++) {
    option_name(option, name);
    if (strlen(name) > width && strlen(name) <= DEEPEST_COLUMN) width = strlen(name);
  }
  return width;
}

static Status print_options(const HelpPage *page, Text *text, Error *error) {
  Status status = STATUS_OK;
  char name[64];
  if (help_option_ends(page->options)) return STATUS_OK;
  TRY(text_append(text, error, "\n"));
  for (const HelpOption *option = page->options; !help_option_ends(option); option++) {
    option_name(option, name);
    TRY(print_entry(name, option->about, options_width(page), text, error));
  }
cleanup:
  return status;
}

static Status print_commands(const HelpPage *page, Text *text, Error *error) {
  Status status = STATUS_OK;
  const char *heading = "\nCommands:\n";
  for (size_t i = 0; i < N_HELP_PAGES; i++) {
    if (!help_is_below(&HELP_PAGES[i], page->name)) continue;
    TRY(text_append(text, error, "%s", heading));
    TRY(print_entry(help_word(&HELP_PAGES[i]), HELP_PAGES[i].about, options_width(page), text, error));
    heading = "";
  }
cleanup:
  return status;
}

static Status print_paragraphs(const char *paragraphs, Text *text, Error *error) {
  Status status = STATUS_OK;
  while (paragraphs && *paragraphs) {
    const size_t length = strcspn(paragraphs, "\n");
    TRY(print_wrapped(paragraphs, length, 0, 0, text, error));
    paragraphs += length + (paragraphs[length] == '\n');
  }
cleanup:
  return status;
}

static Status print_examples(const HelpPage *page, Text *text, Error *error) {
  Status status = STATUS_OK;
  if (page->examples[0].command) TRY(text_append(text, error, "\nExamples:\n"));
  for (const HelpExample *example = page->examples; example->command; example++) {
    TRY(text_append(text, error, "  %s\n", example->command));
    if (example->about) TRY(text_append(text, error, "      %s\n", example->about));
  }
cleanup:
  return status;
}

/* "run a scene ..." as a sentence. */
static Status print_sentence(const char *about, Text *text, Error *error) {
  const size_t start = text->length, length = strlen(about);
  const bool is_question = about[length - 1] == '?';
  const Status status = text_append(text, error, "%s%s", about, is_question ? "\n\n" : ".\n\n");
  if (status == STATUS_OK && about[0] >= 'a' && about[0] <= 'z')
    text->data[start] = (char)(about[0] - 'a' + 'A');
  return status;
}

Status help_print(const HelpPage *page, Text *text, Error *error) {
  Status status;
  if (*page->name)
    TRY(print_sentence(page->about, text, error));
  else
    TRY(text_append(text, error, "Capsella %s.\n\n", page->about));
  TRY(help_print_usage(page, text, error));
  TRY(print_options(page, text, error));
  TRY(print_commands(page, text, error));
  if (page->text) TRY(text_append(text, error, "\n"));
  TRY(print_paragraphs(page->text, text, error));
  TRY(print_examples(page, text, error));
cleanup:
  return status;
}

/* ---- Refusing ---- */

int help_refuse(const char *command, const char *message, const char *found) {
  const HelpPage *page = help_page(command);
  Text usage = {0};
  Error error;
  fprintf(stderr, "capsella %s: %s", command, message);
  if (found) fprintf(stderr, ", found '%s'", found);
  const char *nearest = found && found[0] == '-' ? nearest_option(page, found) : NULL;
  if (nearest && strcmp(nearest, found) != 0) fprintf(stderr, "; did you mean '%s'?", nearest);
  fprintf(stderr, "\n");
  if (help_print_usage(page, &usage, &error) == STATUS_OK)
    fprintf(stderr, "%sTry: capsella help %s\n", usage.data, command);
  text_free(&usage);
  return EXIT_INPUT;
}
