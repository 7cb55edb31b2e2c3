/* report.html: one file that shows a run or a study in a browser, without a network.
 *
 * The page itself (style, script, libraries) is made in web/ and embedded in the program; here the data are
 * put into it.  What it shows follows from the data's "kind": web/src/main.js has one page for each. */
#ifndef CAPSELLA_OBSERVE_PAGE_H
#define CAPSELLA_OBSERVE_PAGE_H

#include "base/status.h"
#include "base/text.h"

/* Appends the whole page with `data`, a JSON document. */
Status page_print(const char *data, Text *html, Error *error);

/* The same into the file report.html of `folder`, written whole or not at all. */
Status page_write(const char *folder, const char *data, Error *error);

#endif
