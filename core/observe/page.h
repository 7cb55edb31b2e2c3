/* report.html: one file that shows a run or a study in a browser, without a network.
 *
 * The page itself (style, script, libraries) is made in web/ and embedded in the program; here the data are
 * gathered and put into it.  What it shows follows from the data's "kind": web/src/main.js has one page for
 * each. */
#ifndef CAPSELLA_OBSERVE_PAGE_H
#define CAPSELLA_OBSERVE_PAGE_H

#include "base/status.h"
#include "base/text.h"
#include "observe/json.h"
#include <stdbool.h>

/* The data of a page from the files of a folder. */
typedef struct {
  const char *folder;
  Json json; /* an open object: more members may be written */
  Text data;
  Error *error;
} Page;

/* `kind` is "run" or "study".  The page stays where it is until page_free. */
void page_begin(Page *page, const char *kind, const char *folder, Error *error);

/* The file NAME of the folder: its text appended; as a string; as the JSON that it is.  Where there is no
 * such file nothing is appended, and the other two are null. */
Status page_read(const Page *page, const char *name, Text *text);
Status page_put_text(Page *page, const char *key, const char *name);
Status page_put_json(Page *page, const char *key, const char *name);

/* Writes FOLDER/report.html, whole or not at all. */
Status page_end(Page *page);
void page_free(Page *page);

/* Appends the whole page with `data`, a JSON document. */
Status page_print(const char *data, Text *html, Error *error);

#endif
