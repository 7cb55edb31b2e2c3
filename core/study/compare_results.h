/* What a study `compare` leaves in its folder: the table, maps of the sites, charts of their angles. */
#ifndef CAPSELLA_STUDY_COMPARE_RESULTS_H
#define CAPSELLA_STUDY_COMPARE_RESULTS_H

#include "study/comparison.h"

Status compare_results_write(const Comparison *comparison, Error *error);

#endif
