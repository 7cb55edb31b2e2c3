/* Man pages from the table of commands. */
#include "app/help.h"
#include <string.h>

/* Words as roff: hyphens as typed, and no control character at the start of a line. */
static Status print_words(const char *words, size_t length, Text *roff, Error *error) {
  Status status = STATUS_OK;
  if (length && (*words == '.' || *words == '\'')) TRY(text_append(roff, error, "\\&"));
  for (size_t i = 0; i < length; i++) {
    if (words[i] == '-')
      TRY(text_append(roff, error, "\\-"));
    else if (words[i] == '\\')
      TRY(text_append(roff, error, "\\e"));
    else
      TRY(text_append_bytes(roff, error, &words[i], 1));
  }
cleanup:
  return status;
}

static Status print_string(const char *words, Text *roff, Error *error) {
  return print_words(words, strlen(words), roff, error);
}

Status help_print_man_name(const HelpPage *page, Text *name, Error *error) {
  Status status;
  TRY(text_append(name, error, "capsella%s%s", *page->name ? "-" : "", page->name));
  for (size_t i = 0; i < name->length; i++)
    if (name->data[i] == ' ') name->data[i] = '-';
cleanup:
  return status;
}

static Status print_title(const HelpPage *page, Text *roff, Error *error) {
  Status status;
  Text name = {0};
  TRY(help_print_man_name(page, &name, error));
  TRY(text_append(roff, error, ".TH \"%s\" 1 \"\" \"capsella " CAPSELLA_VERSION "\"\n", name.data));
  TRY(text_append(roff, error, ".nh\n.ad l\n.SH NAME\n"));
  TRY(print_string(name.data, roff, error));
  TRY(text_append(roff, error, " \\- "));
  TRY(print_string(page->about, roff, error));
cleanup:
  text_free(&name);
  return status;
}

/* The usage line behind its "usage: ", not filled. */
static Status print_synopsis(const HelpPage *page, Text *roff, Error *error) {
  Status status;
  Text usage = {0};
  static const size_t skipped = sizeof "usage: " - 1;
  TRY(help_print_usage(page, &usage, error));
  TRY(text_append(roff, error, "\n.SH SYNOPSIS\n.nf\n"));
  TRY(print_words(usage.data + skipped, usage.length - skipped, roff, error));
  TRY(text_append(roff, error, ".fi"));
cleanup:
  text_free(&usage);
  return status;
}

static Status print_options(const HelpPage *page, Text *roff, Error *error) {
  Status status = STATUS_OK;
  const char *heading = "\n.SH OPTIONS";
  for (const HelpOption *option = page->options; !help_option_ends(option); option++) {
    TRY(text_append(roff, error, "%s\n.TP\n", heading));
    if (option->flag) {
      TRY(text_append(roff, error, "\\fB"));
      TRY(print_string(option->flag, roff, error));
      TRY(text_append(roff, error, "\\fR%s", option->value ? " " : ""));
    }
    if (option->value) TRY(text_append(roff, error, "\\fI%s\\fR", option->value));
    TRY(text_append(roff, error, "\n"));
    TRY(print_string(option->about, roff, error));
    heading = "";
  }
cleanup:
  return status;
}

static Status print_commands(const HelpPage *page, Text *roff, Error *error) {
  Status status = STATUS_OK;
  Text name = {0};
  const char *heading = "\n.SH COMMANDS";
  for (size_t i = 0; i < N_HELP_PAGES; i++) {
    if (!help_is_below(&HELP_PAGES[i], page->name)) continue;
    name.length = 0;
    TRY(help_print_man_name(&HELP_PAGES[i], &name, error));
    TRY(text_append(roff, error, "%s\n.TP\n\\fB", heading));
    TRY(print_string(name.data, roff, error));
    TRY(text_append(roff, error, "\\fR(1)\n"));
    TRY(print_string(HELP_PAGES[i].about, roff, error));
    heading = "";
  }
cleanup:
  text_free(&name);
  return status;
}

static Status print_description(const HelpPage *page, Text *roff, Error *error) {
  Status status = STATUS_OK;
  const char *heading = "\n.SH DESCRIPTION";
  for (const char *paragraph = page->text; paragraph && *paragraph;) {
    const size_t length = strcspn(paragraph, "\n");
    TRY(text_append(roff, error, "%s\n.PP\n", heading));
    TRY(print_words(paragraph, length, roff, error));
    paragraph += length + (paragraph[length] == '\n');
    heading = "";
  }
cleanup:
  return status;
}

static Status print_examples(const HelpPage *page, Text *roff, Error *error) {
  Status status = STATUS_OK;
  const char *heading = "\n.SH EXAMPLES";
  for (const HelpExample *example = page->examples; example->command; example++) {
    TRY(text_append(roff, error, "%s\n.TP\n", heading));
    TRY(print_string(example->command, roff, error));
    TRY(text_append(roff, error, "\n"));
    if (example->about) TRY(print_string(example->about, roff, error));
    heading = "";
  }
cleanup:
  return status;
}

Status help_print_man(const HelpPage *page, Text *roff, Error *error) {
  Status status;
  TRY(print_title(page, roff, error));
  TRY(print_synopsis(page, roff, error));
  TRY(print_options(page, roff, error));
  TRY(print_commands(page, roff, error));
  TRY(print_description(page, roff, error));
  TRY(print_examples(page, roff, error));
  TRY(text_append(roff, error, "\n"));
cleanup:
  return status;
}
