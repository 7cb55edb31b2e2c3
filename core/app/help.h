/* What each command takes, in one table (help_pages.c), and what is printed from it: help, usage lines, man
 * pages and completions of shells. */
#ifndef CAPSELLA_APP_HELP_H
#define CAPSELLA_APP_HELP_H

#include "base/status.h"
#include "base/text.h"
#include <stdbool.h>
#include <stddef.h>

/* What may stand for a value, so that a shell can complete it. */
typedef enum {
  VALUE_OTHER,
  VALUE_YAML,     /* a scene or a study */
  VALUE_FILE,     /* any file */
  VALUE_FOLDER,   /* a folder */
  VALUE_LIBRARY,  /* a .so */
  VALUE_LAW,      /* the id of a law, or a .so */
  VALUE_SETTING,  /* KEY=VALUE of a scene */
  VALUE_CHOICE,   /* one of `choices` */
  VALUE_COMMAND,  /* a command of the program */
  VALUE_COMMAND_2 /* what follows that */
} HelpValue;

typedef struct {
  const char *flag;  /* NULL: an argument without a flag */
  const char *value; /* its name in capitals; NULL: the flag stands alone */
  HelpValue kind;
  const char *choices; /* separated by blanks */
  bool required, repeats;
  const char *about;
} HelpOption;

typedef struct {
  const char *command, *about;
} HelpExample;

enum { HELP_OPTIONS = 12, HELP_EXAMPLES = 6 };

typedef struct {
  const char *name;                    /* "run", "laws check"; "" for the program */
  const char *about;                   /* one line, without capital and full stop */
  HelpOption options[HELP_OPTIONS];    /* arguments first; ends with neither flag nor value */
  const char *text;                    /* paragraphs, separated by newlines; or NULL */
  HelpExample examples[HELP_EXAMPLES]; /* ends with a command of NULL */
} HelpPage;

/* In the order of the help of the program, which is the first. */
extern const HelpPage HELP_PAGES[];
extern const size_t N_HELP_PAGES;

/* The page of the command that `words` [n] begin with: the longest name that fits, NULL when none does. */
const HelpPage *help_find(int n, char *const *words);

/* Of those named so; NULL: none. */
const HelpPage *help_page(const char *name);

/* Whether a page is that of a command right below `parent`: "laws check" below "laws", "run" below "". */
bool help_is_below(const HelpPage *page, const char *parent);

/* The last word of a page's name. */
const char *help_word(const HelpPage *page);

/* The command right below `parent` ("" or "laws") nearest to a misspelt one; NULL when none is near. */
const char *help_nearest(const char *parent, const char *word);

static inline bool help_option_ends(const HelpOption *option) {
  return !option->flag && !option->value;
}

/* "usage: capsella run SCENE.yaml [-o DIR] ..." */
Status help_print_usage(const HelpPage *page, Text *text, Error *error);
Status help_print(const HelpPage *page, Text *text, Error *error);

/* Tells on standard error that the call of a command is wrong, with the nearest option where `found` (may be
 * NULL) is one misspelt, and its usage.  Returns EXIT_INPUT. */
int help_refuse(const char *command, const char *message, const char *found);
#ifdef __clang_analyzer__ /* which sees one file at a time */
#define help_refuse(command, message, found) (help_refuse(command, message, found), 2)
#endif

/* A page for man(1), in section 1. */
Status help_print_man(const HelpPage *page, Text *roff, Error *error);

/* The man page's name: "capsella-laws-check". */
Status help_print_man_name(const HelpPage *page, Text *name, Error *error);

Status help_print_bash(Text *script, Error *error);
Status help_print_zsh(Text *script, Error *error);

#endif
