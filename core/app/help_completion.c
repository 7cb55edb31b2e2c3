/* Completion for bash and zsh from the table of commands, and of the keys of a scene. */
#include "app/help.h"
#include "config/schema.h"
#include <string.h>

static Status print_words_below(const char *parent, Text *script, Error *error) {
  Status status = STATUS_OK;
  const char *separator = "";
  for (size_t i = 0; i < N_HELP_PAGES; i++) {
    if (!help_is_below(&HELP_PAGES[i], parent)) continue;
    TRY(text_append(script, error, "%s%s", separator, help_word(&HELP_PAGES[i])));
    separator = " ";
  }
cleanup:
  return status;
}

/* Keys that one value can be given to. */
static Status print_settings(Text *script, Error *error) {
  Status status = STATUS_OK;
  const char *separator = "";
  for (size_t i = 0; i < SCHEMA_ROWS; i++) {
    if (SCHEMA[i].type == TYPE_GROUP || SCHEMA[i].type == TYPE_PARAMETERS) continue;
    TRY(text_append(script, error, "%s%s=", separator, SCHEMA[i].key));
    separator = " ";
  }
cleanup:
  return status;
}

/* The argument without a flag that comes first; NULL: there is none. */
static const HelpOption *first_argument(const HelpPage *page) {
  return !page->options->flag && page->options->value ? page->options : NULL;
}

/* ---- bash ---- */

static const char BASH_START[] =
    "# Completion of capsella for bash; written by `capsella manual --files`.\n"
    "_capsella_put() {\n"
    "  local IFS=$'\\n'\n"
    "  COMPREPLY=($(\"$@\" -- \"$word\"))\n"
    "}\n"
    "_capsella_words() { _capsella_put compgen -W \"${1// /$'\\n'}\"; }\n"
    "_capsella_folders() { compopt -o filenames 2>/dev/null; _capsella_put compgen -d; }\n"
    "_capsella_files() { # PATTERN\n"
    "  local IFS=$'\\n'\n"
    "  compopt -o filenames 2>/dev/null\n"
    "  COMPREPLY=($(compgen -f -X \"!$1\" -- \"$word\"; compgen -d -- \"$word\"))\n"
    "}\n"
    "_capsella_laws() {\n"
    "  _capsella_words \"$(\"$program\" laws list 2>/dev/null | awk '{ print $2 }' | tr '\\n' ' ')\"\n"
    "  [[ ${#COMPREPLY[@]} -gt 0 ]] || _capsella_files '*.so'\n"
    "}\n"
    "_capsella_settings() {\n"
    "  compopt -o nospace 2>/dev/null\n"
    "  _capsella_words \"$settings\"\n"
    "}\n"
    "_capsella() {\n"
    "  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}\n"
    "  local command=${COMP_WORDS[1]} options=\n"
    "  COMPREPLY=()\n";

static const char BASH_COMMAND[] =
    "  if [[ $COMP_CWORD -eq 1 ]]; then\n"
    "    _capsella_words \"$commands --help --version\"\n"
    "    return\n"
    "  fi\n"
    "  if [[ $command = laws || $command = help ]]; then\n"
    "    if [[ $COMP_CWORD -eq 2 ]]; then\n"
    "      [[ $command = help ]] && _capsella_words \"$commands\" || _capsella_words \"$laws\"\n"
    "      return\n"
    "    fi\n"
    "    command=\"$command ${COMP_WORDS[2]}\"\n"
    "  fi\n"
    "  case \"$command:$before\" in\n"
    "    *:= | *=) return ;;\n"
    "    'help laws':*)\n"
    "      _capsella_words \"$laws\"\n"
    "      return\n"
    "      ;;\n";

static Status print_bash_action(const HelpOption *option, Text *script, Error *error) {
  switch (option->kind) {
  case VALUE_YAML:
    return text_append(script, error, "_capsella_files '*.y*ml'");
  case VALUE_FILE:
    return text_append(script, error, "_capsella_files '*'");
  case VALUE_FOLDER:
    return text_append(script, error, "_capsella_folders");
  case VALUE_LIBRARY:
    return text_append(script, error, "_capsella_files '*.so'");
  case VALUE_LAW:
    return text_append(script, error, "_capsella_laws");
  case VALUE_SETTING:
    return text_append(script, error, "_capsella_settings");
  case VALUE_CHOICE:
    return text_append(script, error, "_capsella_words '%s'", option->choices);
  case VALUE_OTHER:
  case VALUE_COMMAND:
  case VALUE_COMMAND_2:
    break;
  }
  return text_append(script, error, ":");
}

/* What follows an option that takes a value. */
static Status print_bash_values(const HelpPage *page, Text *script, Error *error) {
  Status status = STATUS_OK;
  for (const HelpOption *option = page->options; !help_option_ends(option); option++) {
    if (!option->flag || !option->value) continue;
    TRY(text_append(script, error, "    '%s':%s)\n      ", page->name, option->flag));
    TRY(print_bash_action(option, script, error));
    TRY(text_append(script, error, "\n      return\n      ;;\n"));
  }
cleanup:
  return status;
}

/* The options of a command, and its argument. */
static Status print_bash_command(const HelpPage *page, Text *script, Error *error) {
  Status status;
  TRY(text_append(script, error, "    '%s')\n      options='", page->name));
  for (const HelpOption *option = page->options; !help_option_ends(option); option++)
    if (option->flag) TRY(text_append(script, error, "%s ", option->flag));
  TRY(text_append(script, error, "--help'\n"));
  if (first_argument(page)) {
    TRY(text_append(script, error, "      [[ $word = -* ]] || "));
    TRY(print_bash_action(first_argument(page), script, error));
    TRY(text_append(script, error, "\n"));
  }
  TRY(text_append(script, error, "      ;;\n"));
cleanup:
  return status;
}

Status help_print_bash(Text *script, Error *error) {
  Status status;
  TRY(text_append(script, error, "%s  local commands='", BASH_START));
  TRY(print_words_below("", script, error));
  TRY(text_append(script, error, "' laws='"));
  TRY(print_words_below("laws", script, error));
  TRY(text_append(script, error, "'\n  local settings='"));
  TRY(print_settings(script, error));
  TRY(text_append(script, error, "'\n%s", BASH_COMMAND));
  for (size_t i = 1; i < N_HELP_PAGES; i++) TRY(print_bash_values(&HELP_PAGES[i], script, error));
  TRY(text_append(script, error, "  esac\n  case $command in\n"));
  for (size_t i = 1; i < N_HELP_PAGES; i++) TRY(print_bash_command(&HELP_PAGES[i], script, error));
  TRY(text_append(script, error,
                  "  esac\n"
                  "  [[ $word != -* ]] || _capsella_words \"$options\"\n"
                  "}\n"
                  "complete -F _capsella capsella\n"));
cleanup:
  return status;
}

/* ---- zsh ---- */

/* In single quotes, with what _arguments takes for its own escaped. */
static Status print_zsh_words(const char *words, Text *script, Error *error) {
  Status status = STATUS_OK;
  for (; *words; words++) {
    if (*words == '\'')
      TRY(text_append(script, error, "'\\''"));
    else if (strchr("[]:\\", *words))
      TRY(text_append(script, error, "\\%c", *words));
    else
      TRY(text_append_bytes(script, error, words, 1));
  }
cleanup:
  return status;
}

static const char *zsh_action(HelpValue kind) {
  switch (kind) {
  case VALUE_YAML:
    return "_files -g \"*.(yaml|yml)\"";
  case VALUE_FILE:
    return "_files";
  case VALUE_FOLDER:
    return "_files -/";
  case VALUE_LIBRARY:
    return "_files -g \"*.so\"";
  case VALUE_LAW:
    return "_capsella_laws";
  case VALUE_SETTING:
    return "_capsella_settings";
  case VALUE_COMMAND:
    return "_capsella_commands";
  case VALUE_COMMAND_2:
    return "_capsella_laws_commands";
  case VALUE_OTHER:
  case VALUE_CHOICE:
    break;
  }
  return " ";
}

static Status print_zsh_option(const HelpOption *option, Text *script, Error *error) {
  Status status;
  TRY(text_append(script, error, " \\\n        '"));
  if (option->flag) {
    TRY(text_append(script, error, "%s%s[", option->repeats ? "*" : "", option->flag));
    TRY(print_zsh_words(option->about, script, error));
    TRY(text_append(script, error, "]"));
  }
  if (option->value) {
    TRY(text_append(script, error, ":%s:", option->value));
    if (option->kind == VALUE_CHOICE)
      TRY(text_append(script, error, "(%s)", option->choices));
    else
      TRY(text_append(script, error, "%s", zsh_action(option->kind)));
  }
  TRY(text_append(script, error, "'"));
cleanup:
  return status;
}

static Status print_zsh_command(const HelpPage *page, Text *script, Error *error) {
  Status status;
  TRY(text_append(script, error, "    '%s')\n      _arguments", page->name));
  for (const HelpOption *option = page->options; !help_option_ends(option); option++)
    TRY(print_zsh_option(option, script, error));
  TRY(text_append(script, error, " \\\n        '--help[this text]'\n      ;;\n"));
cleanup:
  return status;
}

/* A function that offers the commands below `parent`. */
static Status print_zsh_commands(const char *function, const char *parent, Text *script, Error *error) {
  Status status;
  TRY(text_append(script, error, "%s() {\n  local -a commands=(\n", function));
  for (size_t i = 0; i < N_HELP_PAGES; i++) {
    if (!help_is_below(&HELP_PAGES[i], parent)) continue;
    TRY(text_append(script, error, "    '%s:", help_word(&HELP_PAGES[i])));
    TRY(print_zsh_words(HELP_PAGES[i].about, script, error));
    TRY(text_append(script, error, "'\n"));
  }
  TRY(text_append(script, error, "  )\n  _describe command commands\n}\n"));
cleanup:
  return status;
}

static const char ZSH_LAWS[] =
    "_capsella_laws() {\n"
    "  local -a laws=(${(f)\"$(capsella laws list 2>/dev/null | awk '{ print $2 }')\"})\n"
    "  _describe law laws\n"
    "  _files -g \"*.so\"\n"
    "}\n";

static const char ZSH_MAIN[] = "_capsella() {\n"
                               "  if (( CURRENT == 2 )); then\n"
                               "    _capsella_commands\n"
                               "    return\n"
                               "  fi\n"
                               "  local command=$words[2]\n"
                               "  shift words\n"
                               "  (( CURRENT-- ))\n"
                               "  if [[ $command = laws ]]; then\n"
                               "    if (( CURRENT == 2 )); then\n"
                               "      _capsella_laws_commands\n"
                               "      return\n"
                               "    fi\n"
                               "    command=\"laws $words[2]\"\n"
                               "    shift words\n"
                               "    (( CURRENT-- ))\n"
                               "  fi\n"
                               "  case $command in\n";

Status help_print_zsh(Text *script, Error *error) {
  Status status;
  TRY(text_append(script, error,
                  "#compdef capsella\n"
                  "# Completion of capsella for zsh; written by `capsella manual --files`.\n"));
  TRY(print_zsh_commands("_capsella_commands", "", script, error));
  TRY(print_zsh_commands("_capsella_laws_commands", "laws", script, error));
  TRY(text_append(script, error, "%s_capsella_settings() {\n  compadd -S '' -- ", ZSH_LAWS));
  TRY(print_settings(script, error));
  TRY(text_append(script, error, "\n}\n%s", ZSH_MAIN));
  for (size_t i = 1; i < N_HELP_PAGES; i++)
    if (strcmp(HELP_PAGES[i].name, "laws") != 0) TRY(print_zsh_command(&HELP_PAGES[i], script, error));
  TRY(text_append(script, error, "  esac\n}\n_capsella \"$@\"\n"));
cleanup:
  return status;
}
