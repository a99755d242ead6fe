// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_CHART_H
#define TESTS_BENCH_CHART_H
/**
 * What the bench's figures have in common: a logarithmic axis of errors that ends
 * in a column for what is wrong, and ways to an answer with their colours and
 * labels.  Positions are in decades: 2 is at 100.
 */
#include "standing.h"
#include <stdio.h>

typedef struct mark {
    const standing *of;
    const char *colour;
    int is_ours, is_wrong;
    double share; // of its answers that are wrong
    double cost, median, max;
    double label; // the height of its label
} mark;

typedef struct chart {
    FILE *out; // the script
    char *script;
    size_t size;
    int measure, marks;
    mark *mark;
    double left, right; // of the errors; smaller ones are drawn at the left
    double end;         // of the column for what is wrong, from the right on
    double low, high;
} chart;

/** 0, or -1 if memory is out; chart_end follows either way. */
int chart_make(chart *g, const contest *c, int measure);

/** The script, to be freed; NULL if memory is out. */
char *chart_end(chart *g);

/** Size, fonts, and the axis of errors. */
void chart_write_frame(const chart *g, const char *unit);

/** Labels of the wrong, or of the right ones: each at its mark's cost and `raise`
 * lines of text above, but no nearer to each other than a line. */
void chart_spread(chart *g, int wrong, double raise);

/** Things in the figure; every one has a tag of its own. */
void chart_line(const chart *g, int tag, double x, double y, double to_x,
                double to_y, const char *colour, const char *how);
void chart_point(const chart *g, int tag, double x, double y, const char *how,
                 const char *colour);
/** A mark's name and what follows it. */
void chart_name(const chart *g, int tag, double x, double y, const char *how,
                const mark *m, const char *rest);
#endif
