// SPDX-License-Identifier: MIT
#ifndef BRINK_REPORT_H
#define BRINK_REPORT_H
/**
 * Figures to a page: one self-contained HTML file of headings, paragraphs, tables
 * and plots, which reads offline, on a telephone, in the light and in the dark.
 *
 * Everything given as text is escaped, so a scene's title may hold what it likes.
 * The first thing that goes wrong is kept; what follows it is skipped, and
 * brink_report_close tells of it, so that a page is written without a check a
 * line.
 */
#include <stdio.h>

typedef struct brink_report {
    FILE *page;
    char *folder;
    char *name;        // of the page
    int columns;       // of the open table
    int column;        // next to be filled; 0: no row is open
    const char *align; // of the open table
    int figures;
    char trouble[600]; // "" while all is well
} brink_report;

/** Begins FOLDER/index.html, in a folder that is made where it is missing.  Only
 *  brink_report_close puts the page in the place of an older one. */
void brink_report_open(brink_report *r, const char *folder, const char *title);

/** The same for FOLDER/NAME.html. */
void brink_report_open_page(brink_report *r, const char *folder, const char *name,
                            const char *title);

/** level 1..3; formats are printf's. */
__attribute__((format(printf, 3, 4))) void
brink_report_heading(brink_report *r, int level, const char *format, ...);
__attribute__((format(printf, 2, 3))) void
brink_report_paragraph(brink_report *r, const char *format, ...);

/** A paragraph set off from the others: what a hurried reader should take away.
 */
__attribute__((format(printf, 2, 3))) void
brink_report_finding(brink_report *r, const char *format, ...);

/** Text kept as it is, line for line: commands, versions. */
__attribute__((format(printf, 2, 3))) void
brink_report_verbatim(brink_report *r, const char *format, ...);

/** A table of `columns` columns, of which align[k] is 'l' for words or 'r' for
 * numbers. Cells are given one by one, row by row; the first of a row is its
 * heading. */
void brink_report_table(brink_report *r, const char *caption, int columns,
                        const char *align, const char *const head[]);
__attribute__((format(printf, 2, 3))) void
brink_report_cell(brink_report *r, const char *format, ...);
void brink_report_table_end(brink_report *r);

/** A drawing that is SVG already: trusted, not escaped. */
void brink_report_drawing(brink_report *r, const char *svg, const char *caption);

/** A figure drawn by gnuplot from a script: see brink_gnuplot_draw.  Its drawing
 * and the script stay beside the page. */
void brink_report_figure(brink_report *r, const char *name, const char *caption,
                         const char *script);

/** Ends the page and puts it in place.  0; or -1 after one line to `errors` on
 * what went wrong first, with no page written and an older one left as it was. */
int brink_report_close(brink_report *r, FILE *errors);

/** Writes text with the five characters escaped that HTML gives a meaning. */
void brink_report_escape(FILE *out, const char *text);
#endif
