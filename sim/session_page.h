// SPDX-License-Identifier: MIT
#ifndef BRINK_SESSION_PAGE_H
#define BRINK_SESSION_PAGE_H
/**
 * What was observed, for people: DIR/observed.html with a table and plots, and
 * beside it what they are drawn from, distances.dat, displacements.dat and
 * speeds.dat.
 */
#include "observe_record.h"
#include "run.h"

/** 0; -1 after a complaint about one of the tables.  Where the page cannot be
 * drawn, for want of gnuplot say, that is told, and the run is none the worse. */
int brink_page_write(const char *dir, const char *title,
                     const brink_record *record, const brink_run *run);
#endif
